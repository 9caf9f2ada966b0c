// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/step_methods.hpp"

#include <algorithm>

#include "solid/step/lagging_friction.hpp"
#include "solid/step/temporarily.hpp"

namespace blockweir::solid {

Outcome StepMethods::try_all(const Stretch& stretch, const StepMode& mode) {
  const auto lagging = [&] { return try_with_lagging_friction(stretch, mode); };
  if (!mode.in_motion() && state_.whole_law.skips() && lagging() == Outcome::made) return Outcome::made;
  if (step_.substitute && mode.in_motion() && state_.multipliers.skips()) return try_by_substitute(stretch, mode);
  Outcome outcome = time_step_.attempt(stretch, mode);
  if (!mode.in_motion() && outcome == Outcome::made) state_.whole_law.succeeded();
  if (mode.in_motion() && outcome == Outcome::made) state_.multipliers.succeeded();
  if (outcome != Outcome::not_found) return outcome;
  if (step_.substitute && mode.in_motion()) state_.multipliers.failed();
  if (step_.substitute) return try_by_substitute(stretch, mode);
  if (mode.in_motion()) return try_far_from_laws(stretch, mode);
  const auto large = [](const IslandEquations& s) { return s.unknowns->total > large_island; };
  if (std::none_of(time_step_.islands().begin(), time_step_.islands().end(), large)) {
    outcome = try_softly(stretch, mode);
    if (outcome == Outcome::not_found) outcome = time_step_.attempt(stretch, mode.with_pivoting());
  }
  if (outcome == Outcome::not_found) {
    outcome = lagging();
    if (outcome == Outcome::made) state_.whole_law.failed();
  }
  return outcome;
}

/// For sweeps that ended far from their laws. A standing structure is worth the thousands of solutions that lagged
/// friction may need; for falling blocks the sweeps are accepted.
Outcome StepMethods::try_far_from_laws(const Stretch& stretch, const StepMode& mode) {
  Outcome outcome = Outcome::not_found;
  const double standing_m_per_s = model_.scene.analysis.gravity_m_per_s2 * stretch.dt;  // of a fall through the step
  if (state_.fastest_m_per_s() <= standing_m_per_s && !state_.lagging.skips()) {
    outcome = try_with_lagging_friction(stretch, mode);
    const bool in_vain = outcome == Outcome::not_found || outcome == Outcome::contacts_change;
    in_vain ? state_.lagging.failed() : state_.lagging.succeeded();
  }
  const bool sweeps = outcome == Outcome::not_found && !mode.smooth_only;
  return sweeps ? time_step_.attempt(stretch, mode.with_rough_sweeps()) : outcome;
}

Outcome StepMethods::try_softly(const Stretch& stretch, const StepMode& mode) {
  Outcome outcome = Outcome::not_found;
  if (formulation_->lagged_friction() == nullptr) return outcome;  // has no penalties of its own
  double& penalty_ratio = formulation_->settings().penalty_ratio;
  const double usual = penalty_ratio;
  for (double ratio = usual / 100; outcome == Outcome::not_found && ratio >= usual / 1e6; ratio /= 100) {
    ++counts_.softened_steps;
    const Temporarily softer(penalty_ratio, ratio);
    outcome = time_step_.attempt(stretch, mode);
  }
  return outcome;
}

Outcome StepMethods::try_with_lagging_friction(const Stretch& stretch, const StepMode& mode) {
  if (formulation_->lagged_friction() == nullptr) return Outcome::not_found;
  FormulationSettings& settings = formulation_->settings();
  ++counts_.lagged_steps;
  const Temporarily softer(settings.penalty_ratio, lagging_penalty_ratio * settings.penalty_ratio);
  const Temporarily lags(settings.friction_lags, true);
  return time_step_.attempt(stretch, mode.with_lagging_friction());
}

Outcome StepMethods::try_by_substitute(const Stretch& stretch, const StepMode& mode) {
  ++counts_.substituted_steps;
  for (ContactPoint& c : state_.contacts) c.penalty = 0;
  for (Support& s : state_.supports) s.penalty = 0;
  const TradePlaces stands_in(formulation_, step_.substitute);
  const Outcome outcome = time_step_.attempt(stretch, mode);
  if (outcome == Outcome::made || outcome == Outcome::too_far) return outcome;
  return mode.in_motion() ? try_far_from_laws(stretch, mode) : try_with_lagging_friction(stretch, mode);
}

}  // namespace blockweir::solid
