// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that Lagrange multipliers cannot settle, made by the augmented Lagrangian, whose answer is the same.
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Penalties are its own from here on.
bool Solid::attempt_by_substitute(double dt, double end_s, const std::vector<Panel>& water) {
  ++counts_.substituted_steps;
  for (ContactPoint& c : contacts_) c.penalty = 0;
  for (Support& s : supports_) s.penalty = 0;
  formulation_.swap(substitute_);
  const bool solved = attempt(dt, end_s, water) || (!goes_too_far_ && attempt_with_lagging_friction(dt, end_s, water));
  formulation_.swap(substitute_);
  return solved;
}

}  // namespace blockweir::solid
