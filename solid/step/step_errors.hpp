// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of steps that cannot be made, and of values that are not finite numbers.
#pragma once

#include "solid/step/island_equations.hpp"
#include "solid/step/step_workspace.hpp"

namespace blockweir::solid {

[[noreturn]] void refuse_step(const StepWorkspace& step, double time_s, double dt, Outcome last);
/// Supports of a static analysis could be led that share of their way only.
[[noreturn]] void refuse_supports(const StepWorkspace& step, double share, double at_s);
/// No initial equilibrium was found in so many steps; `last` is the outcome of the last one.
[[noreturn]] void refuse_start(const StepWorkspace& step, int steps, int most_steps, Outcome last);
[[noreturn]] void refuse_number(const StepWorkspace& step, std::size_t b, const char* what, double time_s);
/// Throws for a block with strains that no solid has: its modulus or size is probably in other units.
void require_small_strains(const StepWorkspace& step);
void require_finite(const StepWorkspace& step, double time_s);
void require_finite_loads(const StepWorkspace& step, double time_s);
/// Forces may overflow in a step that is too long; those that are not numbers end the run.
void require_numbers(const StepWorkspace& step, const IslandEquations& island);

}  // namespace blockweir::solid
