// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the method that finds the equilibrium of an island.
#pragma once

#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

/// Not in static analyses, which need round-off accuracy, and not in steps whose contact states must not change.
[[nodiscard]] bool may_sweep(const StepWorkspace& step, const StepMode& mode);

/// Newton's method, then the methods that the mode allows. `newton`: whether to try Newton's method.
Found find_equilibrium(StepWorkspace& step, IslandEquations& island, const StepMode& mode, bool newton);

/// With the full Coulomb law, or with lagged friction bounds.
bool find_by_newton(StepWorkspace& step, IslandEquations& island, const StepMode& mode);

}  // namespace blockweir::solid
