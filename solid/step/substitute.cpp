// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that Lagrange multipliers cannot settle, made by the augmented Lagrangian, whose answer is the same.
#include "solid/step/solid.hpp"
#include "solid/step/temporarily.hpp"

namespace blockweir::solid {

/// Penalties are its own from here on.
Outcome Solid::attempt_by_substitute(const Stretch& stretch, const StepMode& mode) {
  ++counts_.substituted_steps;
  for (ContactPoint& c : contacts_) c.penalty = 0;
  for (Support& s : supports_) s.penalty = 0;
  const TradePlaces stands_in(formulation_, substitute_);
  const Outcome outcome = attempt(stretch, mode);
  if (outcome == Outcome::made || outcome == Outcome::too_far) return outcome;
  return attempt_with_lagging_friction(stretch, mode);
}

}  // namespace blockweir::solid
