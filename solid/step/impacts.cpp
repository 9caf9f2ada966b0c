// SPDX-License-Identifier: GPL-3.0-or-later
// An impact is not a smooth motion. A rule of second order weighs the forces of the step's beginning, which an impact
// does not continue, and makes energy of it: steps in which contacts change are made by Shi's scheme, which takes.
#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// A step by the scene's integrator; by Shi's scheme where contacts close, open, begin or cease to slip in it, and for
/// one more, whose acceleration is that of the forces that act.
Outcome Solid::make_step(const Stretch& stretch) {
  made_by_shi_ = true;
  const StepMode own{.scheme = scheme_};
  // Without velocities a step as short as the scene's would hold back by inertia what is led, and let it spring back at
  // rest: one long against elastic periods follows what is led through states of rest.
  constexpr double longer = 10;
  if (scene_.analysis.kind == scene::AnalysisKind::quasi_static) {
    const double long_s = longer * pseudo_step_s();
    if (long_s > stretch.dt && try_step({long_s, stretch.end_s, stretch.water}, own) == Outcome::made) {
      return Outcome::made;
    }
  }
  if (!scheme_.second_order() || !scheme_.damps) return try_step(stretch, own);
  if (smooth_steps_ >= smooth_steps_before_restart) {
    const Outcome smooth = try_step(stretch, {.scheme = scheme_, .smooth_only = true});
    made_by_shi_ = smooth != Outcome::made;
    if (smooth == Outcome::made || smooth == Outcome::too_far) return smooth;
    smooth_steps_ = 0;
  }
  const Outcome outcome = try_step(stretch, {});
  if (outcome != Outcome::made) return outcome;
  ++counts_.impact_steps;
  smooth_steps_ = contacts_change() ? 0 : smooth_steps_ + 1;
  return outcome;
}

/// Viscous forces of a step by Shi's scheme go by its mean rates. The trapezoidal rule goes on from those of its end:
/// their mean over a step is that of the step's mean rate, and takes. Generalized-alpha weighs them otherwise and would
/// make energy of them.
void Solid::act_by_end_rates(std::size_t b, double dt) {
  if (scene_.analysis.integrator != scene::Integrator::trapezoidal || !newmark_.damps) return;
  BlockState& state = states_[b];
  const Vector6 beyond = state.velocity - increment_[b] / dt;
  const double drag = scene_.analysis.mass_damping_per_s;
  state.acceleration -= drag * beyond;
  balance_[b] -= drag * (blocks_[b].inertia * beyond);
  if (blocks_[b].rigid || retardation_s(b) == 0) return;
  const Eigen::Vector3d strain = retardation_s(b) * (blocks_[b].stiffness * beyond.tail<3>());
  balance_[b].tail<3>() -= strain;
  const Eigen::Matrix4d inertia = blocks_[b].inertia.matrix().bottomRightCorner<4, 4>();
  state.acceleration.tail<4>() -= inertia.ldlt().solve(Eigen::Vector4d(0, strain[0], strain[1], strain[2]));
}

bool Solid::contacts_change() {
  return std::any_of(islands_.begin(), islands_.end(),
                     [this](const IslandSystem& s) { return formulation_->changed(held_by(s)); });
}

long Solid::touching_contacts() const {
  return std::count_if(contacts_.begin(), contacts_.end(),
                       [](const ContactPoint& c) { return c.state != ContactState::open; });
}

}  // namespace blockweir::solid
