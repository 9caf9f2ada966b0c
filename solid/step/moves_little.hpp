// SPDX-License-Identifier: GPL-3.0-or-later
// Whether an island begins a step as good as at rest.
#pragma once

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

/// By so much of a fall through the step may gaps and slips be off their laws when sweeps end.
constexpr double enough_share = 1e-4;

/// Do its blocks begin the step so slowly that they would hardly go farther than that?
[[nodiscard]] bool moves_little(const StepWorkspace& step, const IslandEquations& island);

}  // namespace blockweir::solid
