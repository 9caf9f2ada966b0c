// SPDX-License-Identifier: GPL-3.0-or-later
// The sequence of methods that are tried for a step.
#pragma once

#include "solid/step/time_step.hpp"

namespace blockweir::solid {

class StepMethods : StepPart {
 public:
  StepMethods(StepWorkspace& step, TimeStep& time_step) : StepPart(step), time_step_(time_step) {}

  /// Tries all methods that a mode allows, in turn. In motion contacts are solved by sweeps if Newton's method does not
  /// find their states. Equilibrium must be exact: if states cycle there with the full Coulomb law, friction bounds
  /// lag, and this is kept for a while. If contacts are redundant, states with Lagrange multipliers cycle; then the
  /// augmented Lagrangian makes the step. If a bond is about to break while settling, and no states are found with or
  /// without it, sweeps are used, too.
  Outcome try_all(const Stretch& stretch, const StepMode& mode);

  /// Tries a smaller penalty. A large one leaves a sticking contact a narrow range of slips, between whose ends
  /// Newton's method may jump; a smaller one needs more sweeps of multipliers. For small structures, where lagged
  /// friction converges badly.
  Outcome try_softly(const Stretch& stretch, const StepMode& mode);
  Outcome try_with_lagging_friction(const Stretch& stretch, const StepMode& mode);
  /// For steps that fail with Lagrange multipliers. From here on penalties are those of the substitute.
  Outcome try_by_substitute(const Stretch& stretch, const StepMode& mode);

 private:
  Outcome try_far_from_laws(const Stretch& stretch, const StepMode& mode);

  TimeStep& time_step_;
};

}  // namespace blockweir::solid
