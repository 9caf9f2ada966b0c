// SPDX-License-Identifier: GPL-3.0-or-later
// Broad phase: pairs of blocks with close bounding boxes, found on a uniform grid.
#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

namespace blockweir::solid {

using Box = Eigen::AlignedBox2d;

/// Pairs (lower index, higher index), in increasing order, whose boxes overlap. `movable[i]` is false for fixed blocks;
/// two fixed blocks make no pair. Boxes much larger than the typical one (a foundation) are compared with all others
/// instead of being entered in the grid.
std::vector<std::pair<int, int>> neighbours(const std::vector<Box>& boxes, const std::vector<bool>& movable);

}  // namespace blockweir::solid
