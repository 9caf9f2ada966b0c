// SPDX-License-Identifier: GPL-3.0-or-later
// The length by which a scene's own lengths are measured, so that a model in the laboratory and a mountain behave
// alike.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// The larger side of the box around all that can move, or around all blocks where nothing can [m]; 1 without blocks.
double structure_size_m(const std::vector<Block>& blocks);

/// Median, over the blocks that can move, of the lesser side of the box around each [m]; infinite where none can.
double typical_width_m(const std::vector<Block>& blocks);

}  // namespace blockweir::scene
