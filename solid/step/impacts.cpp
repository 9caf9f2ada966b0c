// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/impacts.hpp"

namespace blockweir::solid {

void StepsWithImpacts::start_acceleration(const std::vector<Panel>& water, double from_s) {
  const Standing before = state_;
  const EnergyBalance balance = state_.energy;
  const double dt = 1e-2 * model_.scene.analysis.step_s;
  const bool solved = time_step_.attempt({dt, from_s + dt, water}, {}) == Outcome::made;
  const std::vector<BlockState> first = state_.blocks;
  const std::vector<Support> supports = state_.supports;
  state_.restore(before);
  state_.energy.undo_work_since(balance);
  state_.smooth_steps = solved ? State::smooth_steps_before_restart : 0;
  if (!solved) return;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    state_.blocks[b].acceleration = first[b].acceleration;
    // With water to push there is inertia beyond the blocks' own: what balanced it is the force.
    state_.blocks[b].force = water_.couples() ? first[b].force : Vector6(trial_.inertia(b) * first[b].acceleration);
  }
  for (std::size_t k = 0; k < supports.size(); ++k) {
    state_.supports[k].force = supports[k].force;
    state_.supports[k].inertial = supports[k].inertial;
  }
}

Outcome StepsWithImpacts::make(const Stretch& stretch) {
  made_by_shi_ = true;
  const StepMode own{.scheme = model_.scheme};
  // For steps without velocities. A step as short as the scene's would hold prescribed motion back by inertia and let
  // it spring back at rest; a step long against elastic periods follows it through equilibria.
  constexpr double longer = 10;
  if (model_.is(scene::AnalysisKind::quasi_static)) {
    const double long_s = longer * model_.pseudo_step_s();
    if (long_s > stretch.dt && methods_.try_all({long_s, stretch.end_s, stretch.water}, own) == Outcome::made) {
      return Outcome::made;
    }
  }
  if (!model_.scheme.second_order() || !model_.scheme.damps) return methods_.try_all(stretch, own);
  if (state_.smooth_steps >= State::smooth_steps_before_restart) {
    const Outcome smooth = methods_.try_all(stretch, {.scheme = model_.scheme, .smooth_only = true});
    made_by_shi_ = smooth != Outcome::made;
    if (smooth == Outcome::made) ++state_.smooth_steps;
    if (smooth == Outcome::made || smooth == Outcome::too_far) return smooth;
    state_.smooth_steps = 0;
  }
  const Outcome outcome = methods_.try_all(stretch, {});
  if (outcome != Outcome::made) return outcome;
  ++counts_.impact_steps;
  state_.smooth_steps = time_step_.contacts_change() ? 0 : state_.smooth_steps + 1;
  return outcome;
}

}  // namespace blockweir::solid
