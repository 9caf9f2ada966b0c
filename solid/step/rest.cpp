// SPDX-License-Identifier: GPL-3.0-or-later
// Static analysis, and the end of each window of a quasi-static one: steps until what is unbalanced is small, or the
// structure is on the move.
#include <algorithm>
#include <cmath>
#include <utility>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// With velocities reset at every step, inertia is what the forces leave unbalanced.
double Solid::unbalanced_ratio() const {
  double largest = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (frozen_[b]) continue;
    const Vector6 inertia = newmark_.mass_factor(matrices_dt_) * (blocks_[b].inertia * increment_[b]);
    largest = std::max({largest, inertia.head<2>().cwiseAbs().maxCoeff(), std::abs(inertia[2]) / blocks_[b].radius});
  }
  return largest / force_scale_;
}

void Solid::come_to_rest(const std::vector<Panel>& water, double at_s) {
  constexpr int most_steps = 1000;
  constexpr double shortest = 1e-6;  // of the pseudo-step that the search begins with
  const double longest = pseudo_step_s();
  const StepMode still{.scheme = {.damps = false}};
  const double before_m = largest_displacement_m();
  loads_.start_base();
  rest_ = {};
  for (double dt = longest; rest_.steps < most_steps && dt > shortest * longest;) {
    for (BlockState& state : states_) state.velocity.setZero(), state.acceleration.setZero();
    if (try_step({dt, at_s, water}, still) != Outcome::made) {
      dt /= 4;
      continue;
    }
    ++rest_.steps;
    const double before = std::exchange(rest_.unbalanced, unbalanced_ratio());
    const bool swept = std::any_of(islands_.begin(), islands_.end(), [](const auto& s) { return s.swept; });
    rest_.found = !swept && rest_.unbalanced <= scene_.analysis.residual_tolerance;
    // What only strains or settles halves what is unbalanced, however far it goes; what slides or turns does not.
    const bool settles = rest_.steps == 1 || rest_.unbalanced < before / 2;
    const bool far = largest_displacement_m() - before_m > scene_.analysis.failure_displacement_m;
    if (rest_.found || (far && !settles)) break;
    dt = settles ? std::min(std::max(longest, dt), 2 * dt) : 2 * dt;
  }
  if (!rest_.found) return;  // velocities tell where it goes
  for (BlockState& state : states_) state.velocity.setZero(), state.acceleration.setZero();
}

}  // namespace blockweir::solid
