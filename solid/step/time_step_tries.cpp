// SPDX-License-Identifier: GPL-3.0-or-later
// The methods by which a step is tried.
#include <algorithm>

#include "solid/step/lagging_friction.hpp"
#include "solid/step/temporarily.hpp"
#include "solid/step/time_step.hpp"

namespace blockweir::solid {

/// In motion contacts are swept where Newton's method does not find their states. A state of rest is to be exact: where
/// the whole of Coulomb's law runs in circles there, friction lags, and is left to for a while. Where contacts are
/// redundant, states of Lagrange multipliers run in circles: the augmented Lagrangian makes such a step. Where a bond
/// is about to break on the way to rest and no states are found with it or without, contacts are swept as well.
Outcome TimeStep::try_all(const Stretch& stretch, const StepMode& mode) {
  const auto lagging = [&] { return attempt_with_lagging_friction(stretch, mode); };
  if (!mode.in_motion() && state_.whole_law.skips() && lagging() == Outcome::made) return Outcome::made;
  Outcome outcome = attempt(stretch, mode);
  if (!mode.in_motion() && outcome == Outcome::made) state_.whole_law.succeeded();
  if (outcome != Outcome::not_found) return outcome;
  if (step_.substitute) return attempt_by_substitute(stretch, mode);
  if (mode.in_motion()) return try_far_from_laws(stretch, mode);
  const auto large = [](const IslandEquations& s) { return s.unknowns->total > large_island; };
  if (std::none_of(islands_.begin(), islands_.end(), large)) {
    outcome = attempt_softly(stretch, mode);
    if (outcome == Outcome::not_found) outcome = attempt(stretch, mode.with_pivoting());
  }
  if (outcome == Outcome::not_found) {
    outcome = lagging();
    if (outcome == Outcome::made) state_.whole_law.failed();
  }
  return outcome;
}

/// Where sweeps have ended far from their laws. What stands is worth the thousands of solutions that lagging friction
/// may take; of what falls they count all the same.
Outcome TimeStep::try_far_from_laws(const Stretch& stretch, const StepMode& mode) {
  Outcome outcome = Outcome::not_found;
  const double standing_m_per_s = model_.scene.analysis.gravity_m_per_s2 * stretch.dt;  // of a fall through the step
  if (state_.fastest_m_per_s() <= standing_m_per_s && !state_.lagging.skips()) {
    outcome = attempt_with_lagging_friction(stretch, mode);
    outcome == Outcome::not_found ? state_.lagging.failed() : state_.lagging.succeeded();
  }
  return outcome == Outcome::not_found ? attempt(stretch, mode.with_rough_sweeps()) : outcome;
}

/// A large penalty leaves a sticking contact a narrow range of slips, in which Newton's method may jump to and fro
/// between states; a smaller one takes more sweeps of multipliers. Of small structures, which friction that lags serves
/// badly.
Outcome TimeStep::attempt_softly(const Stretch& stretch, const StepMode& mode) {
  Outcome outcome = Outcome::not_found;
  if (!formulation_->can_lag_friction()) return outcome;  // has no penalties of its own
  double& penalty_ratio = formulation_->settings().penalty_ratio;
  const double usual = penalty_ratio;
  for (double ratio = usual / 100; outcome == Outcome::not_found && ratio >= usual / 1e6; ratio /= 100) {
    ++counts_.softened_steps;
    const Temporarily softer(penalty_ratio, ratio);
    outcome = attempt(stretch, mode);
  }
  return outcome;
}

Outcome TimeStep::attempt_with_lagging_friction(const Stretch& stretch, const StepMode& mode) {
  if (!formulation_->can_lag_friction()) return Outcome::not_found;
  FormulationSettings& settings = formulation_->settings();
  ++counts_.lagged_steps;
  const Temporarily softer(settings.penalty_ratio, lagging_penalty_ratio * settings.penalty_ratio);
  const Temporarily lags(settings.friction_lags, true);
  return attempt(stretch, mode.with_lagging_friction());
}

/// Penalties are its own from here on.
Outcome TimeStep::attempt_by_substitute(const Stretch& stretch, const StepMode& mode) {
  ++counts_.substituted_steps;
  for (ContactPoint& c : state_.contacts) c.penalty = 0;
  for (Support& s : state_.supports) s.penalty = 0;
  const TradePlaces stands_in(formulation_, step_.substitute);
  const Outcome outcome = attempt(stretch, mode);
  if (outcome == Outcome::made || outcome == Outcome::too_far) return outcome;
  return mode.in_motion() ? try_far_from_laws(stretch, mode) : attempt_with_lagging_friction(stretch, mode);
}

}  // namespace blockweir::solid
