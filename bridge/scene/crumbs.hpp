// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks so small that their motion says nothing of the structure: joints that happen to meet cut them out.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// For each block, whether its area is below a ten-thousandth of the median over the blocks that can move.
std::vector<bool> crumbs(const std::vector<Block>& blocks);

}  // namespace blockweir::scene
