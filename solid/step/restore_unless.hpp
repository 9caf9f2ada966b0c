// SPDX-License-Identifier: GPL-3.0-or-later
// A search in an island that restores the previous trial if it fails.
#pragma once

#include <functional>

#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

/// Returns the result of `search`; if that is false, restores the island's trial.
bool restore_unless(StepWorkspace& step, IslandEquations& island, const StepMode& mode,
                    const std::function<bool()>& search);

}  // namespace blockweir::solid
