// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of touching blocks of an island, and their rigid motions.
#pragma once

#include <vector>

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

/// Whether a contact is closed at the start or the end of the step.
[[nodiscard]] bool touches(const StepWorkspace& step, int contact);

/// For each of an island's blocks the first block (indices within the island) of its group: blocks connected by
/// touching, bolts or a mesh.
[[nodiscard]] std::vector<int> touching_groups(const StepWorkspace& step, const IslandEquations& island);

/// Columns: rates of a block, in the form of the state, for unit translations in x and y and a rotation about a point.
[[nodiscard]] Eigen::Matrix<double, 6, 3> rigid_motions(const Block& block, const Placement& placement,
                                                        const Point& about);

}  // namespace blockweir::solid
