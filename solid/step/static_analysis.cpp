// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/static_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solid/step/step_errors.hpp"

namespace blockweir::solid {

double StaticAnalysis::unbalanced_ratio() const {
  double largest = 0;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    if (trial_.frozen[b]) continue;
    const Vector6 inertia = trial_.scheme.mass_factor(trial_.dt) * (model_.blocks[b].inertia * trial_.increment[b]);
    largest =
        std::max({largest, inertia.head<2>().cwiseAbs().maxCoeff(), std::abs(inertia[2]) / model_.blocks[b].radius});
  }
  return largest / model_.weight_n_per_m;
}

bool StaticAnalysis::lead_supports(const std::vector<Panel>& water, double at_s) {
  constexpr double of_a_step = 0.25;  // of the way that a step may go: blocks turn and strain beside
  constexpr double shortest = 1e-6;   // of the whole way
  constexpr Search roughly{.most_steps = 50, .balanced = 1e-4};  // on the way
  const StepMode still{.scheme = {.damps = false}};
  const auto lead = [this](double share) {
    for (Support& support : state_.supports) support.share = share;
  };
  double led = state_.supports.empty() ? 1 : state_.supports.front().share;
  if (led == 1) return true;
  lead(1);
  double farthest_m = 0;
  for (const Support& support : state_.supports) farthest_m = std::max(farthest_m, support.target(at_s).norm());
  if (farthest_m == 0) return true;
  const double longest = of_a_step * model_.scene.analysis.max_displacement_ratio * model_.size_m / farthest_m;
  double stride = longest;
  while (led < 1) {
    const double next = led + stride < 1 ? led + stride : 1;
    lead(next);
    state_.stop();
    // Where states are hard to find, a shorter step helps by its inertia, too.
    const double dt = model_.pseudo_step_s() * std::max(1e-2, std::min(1.0, stride / longest));
    if (methods_.try_all({dt, at_s, water}, still) == Outcome::made) {
      led = next;
      find_rest(water, at_s, roughly);  // what lags behind has not failed, what moves on without them has
      if (!state_.rest.found && state_.rest.steps < roughly.most_steps) return false;
      stride = std::min(longest, 2 * stride);
      continue;
    }
    stride /= 4;
    if (stride >= shortest) continue;
    lead(1);
    refuse_supports(step_, led, at_s);
  }
  state_.stop();
  return true;
}

bool StaticAnalysis::must_move(const std::vector<Panel>& water, double at_s) {
  state_.stop();
  step_.must_move = false;
  time_step_.attempt({model_.pseudo_step_s(), at_s, water}, {.scheme = {.damps = false}, .stays = true});
  return step_.must_move;
}

void StaticAnalysis::come_to_rest(const std::vector<Panel>& water, double at_s, int most_steps) {
  if (!lead_supports(water, at_s)) return;
  find_rest(water, at_s, {most_steps, model_.scene.analysis.residual_tolerance});
}

void StaticAnalysis::find_rest(const std::vector<Panel>& water, double at_s, const Search& search) {
  constexpr double shortest = 1e-6;     // of the pseudo-step that the search begins with
  constexpr double brief = 1e-3;        // the same: inertia then keeps what is swept from another state of rest
  constexpr double short_share = 1e-2;  // the same: shorter steps hardly move anything
  constexpr int stuck_after = 20;       // of these in a row
  const double longest = model_.pseudo_step_s();
  const StepMode still{.scheme = {.damps = false}};
  int short_steps = 0;
  const double before_m = state_.largest_displacement_m(model_);
  const double slipped_m = state_.largest_slip_m();
  const double far_m = model_.scene.analysis.failure_displacement_m;
  double failed = std::numeric_limits<double>::infinity();  // the last step length that found no states
  Backoff as_long;  // as many steps again: creep makes hundreds of steps, and a failed attempt costs as many
  state_.rest = {};
  for (double dt = longest; state_.rest.steps < search.most_steps && dt > shortest * longest;) {
    state_.stop();
    const Stretch stretch{dt, at_s, water};
    Outcome outcome = methods_.try_all(stretch, still);
    // A bond is about to break, or there are too many states to find some among: sweeps come near. They would find a
    // rest that blocks which fail never come to, so that these are followed first.
    if (outcome == Outcome::not_found && (short_steps >= stuck_after || dt < brief * longest)) {
      outcome = time_step_.attempt(stretch, still.with_sweeps());
    }
    if (outcome != Outcome::made) {
      if (dt == failed) as_long.failed();
      failed = dt;
      dt /= 4;
      continue;
    }
    ++state_.rest.steps;
    short_steps = dt < short_share * longest || short_steps >= stuck_after ? short_steps + 1 : 0;
    if (short_steps == stuck_after) dt = longest, failed = std::numeric_limits<double>::infinity();
    const double before = std::exchange(state_.rest.unbalanced, unbalanced_ratio());
    state_.rest.found = !time_step_.any_swept() && state_.rest.unbalanced <= search.balanced;
    // Strain and settlement halve the imbalance, however far they go; sliding and rotation do not.
    const bool settles = state_.rest.steps == 1 || state_.rest.unbalanced < before / 2;
    const bool far = state_.largest_displacement_m(model_) - before_m > far_m;
    // A slip that is stopped by an anchor or neighbour after this distance has failed before, even if strain caused it.
    state_.rest.found = state_.rest.found && state_.largest_slip_m() - slipped_m <= far_m + before_m;
    if (state_.rest.found || (far && !settles)) break;
    const double longer = settles ? std::min(std::max(longest, dt), 2 * dt) : 2 * dt;
    if (longer < failed || !as_long.skips()) dt = longer;
  }
  if (!state_.rest.found) return;  // velocities show where it moves
  state_.stop();
}

}  // namespace blockweir::solid
