// SPDX-License-Identifier: GPL-3.0-or-later
// A search in an island that may be in vain.
#pragma once

#include <functional>

#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

/// What the search finds, or the island's trial as it was.
bool restore_unless(StepWorkspace& step, IslandEquations& island, const StepMode& mode,
                    const std::function<bool()>& search);

}  // namespace blockweir::solid
