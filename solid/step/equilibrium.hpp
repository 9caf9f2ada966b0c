// SPDX-License-Identifier: GPL-3.0-or-later
// Which method finds the equilibrium of an island.
#pragma once

#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

/// Static analyses ask for round-off, which sweeps do not reach; steps that are to be smooth for states that stay.
[[nodiscard]] bool may_sweep(const StepWorkspace& step, const StepMode& mode);

/// Newton's method, then what the mode lets follow. `newton`: is it worth a try?
Found find_equilibrium(StepWorkspace& step, IslandEquations& island, const StepMode& mode, bool newton);

/// By the whole of Coulomb's law, or with friction that lags.
bool find_by_newton(StepWorkspace& step, IslandEquations& island, const StepMode& mode);

}  // namespace blockweir::solid
