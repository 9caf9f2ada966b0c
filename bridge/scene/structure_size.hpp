// SPDX-License-Identifier: GPL-3.0-or-later
// The reference length of a scene. Default lengths are shares of it, so that a laboratory model and a mountain behave
// alike.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Larger side of the box around all moving blocks, or around all blocks if none moves [m]; 1 without blocks.
double structure_size_m(const std::vector<Block>& blocks);

/// Median over the moving blocks of the smaller side of each one's box [m]; infinite if none moves.
double typical_width_m(const std::vector<Block>& blocks);

}  // namespace blockweir::scene
