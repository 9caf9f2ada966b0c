// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that cannot be made, and numbers that are none: what is said of them.
#pragma once

#include "solid/step/island_equations.hpp"
#include "solid/step/step_workspace.hpp"

namespace blockweir::solid {

[[noreturn]] void refuse_step(double time_s, double dt, Outcome last);
/// No start was found in so many steps, of which the last ended so.
[[noreturn]] void refuse_start(const StepWorkspace& step, int steps, int most_steps, Outcome last);
[[noreturn]] void refuse_number(const StepWorkspace& step, std::size_t b, const char* what, double time_s);
/// A block that is strained as no solid is: its modulus or its size is in other units.
void require_small_strains(const StepWorkspace& step);
void require_finite(const StepWorkspace& step, double time_s);
void require_finite_loads(const StepWorkspace& step, double time_s);
/// Forces that overflow may do so for too long a step; those that are no numbers end the run.
void require_numbers(const StepWorkspace& step, const IslandEquations& island);

}  // namespace blockweir::solid
