// SPDX-License-Identifier: GPL-3.0-or-later
// Broad phase: pairs of blocks whose bounding boxes come near each other, found on a uniform grid.
#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

namespace blockweir::solid {

using Box = Eigen::AlignedBox2d;

/// Pairs (low index, high index), in increasing order, whose boxes overlap. `movable[i]` is false for fixed
/// blocks; two of them make no pair. Boxes that are much larger than the typical one (a foundation) are held
/// against all others instead of being spread over the grid.
std::vector<std::pair<int, int>> neighbours(const std::vector<Box>& boxes, const std::vector<bool>& movable);

}  // namespace blockweir::solid
