// SPDX-License-Identifier: GPL-3.0-or-later
// The methods by which a step is tried.
#pragma once

#include "solid/step/time_step.hpp"

namespace blockweir::solid {

class StepMethods : StepPart {
 public:
  StepMethods(StepWorkspace& step, TimeStep& time_step) : StepPart(step), time_step_(time_step) {}

  /// By all methods that a mode has, in turn. In motion contacts are swept where Newton's method does not find their
  /// states. A state of rest is to be exact: where the whole of Coulomb's law runs in circles there, friction lags, and
  /// is left to for a while. Where contacts are redundant, states of Lagrange multipliers run in circles: the augmented
  /// Lagrangian makes such a step. Where a bond is about to break on the way to rest and no states are found with it or
  /// without, contacts are swept as well.
  Outcome try_all(const Stretch& stretch, const StepMode& mode);

  /// A large penalty leaves a sticking contact a narrow range of slips, in which Newton's method may jump to and fro
  /// between states; a smaller one takes more sweeps of multipliers. Of small structures, which friction that lags
  /// serves badly.
  Outcome try_softly(const Stretch& stretch, const StepMode& mode);
  Outcome try_with_lagging_friction(const Stretch& stretch, const StepMode& mode);
  /// Of steps that Lagrange multipliers cannot settle. Penalties are the substitute's from here on.
  Outcome try_by_substitute(const Stretch& stretch, const StepMode& mode);

 private:
  Outcome try_far_from_laws(const Stretch& stretch, const StepMode& mode);

  TimeStep& time_step_;
};

}  // namespace blockweir::solid
