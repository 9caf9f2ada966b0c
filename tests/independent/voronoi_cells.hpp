// SPDX-License-Identifier: GPL-3.0-or-later
// A convex outline cut into the cells of points: each holds what is nearer to its point than to any other.
#pragma once

#include "tests/independent/structure.hpp"

namespace blockweir::independent {

/// Empty where a cell would have a side shorter than `shortest_m`.
std::vector<std::vector<Vec>> voronoi_cells(const std::vector<Vec>& outline, const std::vector<Vec>& points,
                                            double shortest_m);

}  // namespace blockweir::independent
