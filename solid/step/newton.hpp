// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of one island at the end of a step: Newton's method on (5)-(6) with open-close iterations inside, and an
// update of the multipliers (8) each time it has converged.
#pragma once

#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

class Newton : StepPart {
 public:
  explicit Newton(StepWorkspace& step) : StepPart(step) {}

  /// With the full Coulomb law: false if the contact states are not found.
  bool find(IslandEquations& island, const StepMode& mode);

 private:
  [[nodiscard]] int turn(int unknowns, const StepMode& mode) const;
  double unbalanced_in_these_states(IslandEquations& island, const StepMode& mode);
  bool update_multipliers(IslandEquations& island);
};

}  // namespace blockweir::solid
