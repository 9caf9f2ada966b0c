// SPDX-License-Identifier: GPL-3.0-or-later
// Which blocks of an island touch each other in a step, and how they move as one.
#pragma once

#include <vector>

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

/// Is a contact closed as the step begins or as it ends?
[[nodiscard]] bool touches(const StepWorkspace& step, int contact);

/// Of each of an island's blocks the first, as indices within the island, of those that it touches, or that bolts or a
/// mesh join with it.
[[nodiscard]] std::vector<int> touching_groups(const StepWorkspace& step, const IslandEquations& island);

/// Columns: rates of a block, as its state has them, that moves with (x, y) and turns about a point.
[[nodiscard]] Eigen::Matrix<double, 6, 3> rigid_motions(const Block& block, const Placement& placement,
                                                        const Point& about);

}  // namespace blockweir::solid
