// SPDX-License-Identifier: GPL-3.0-or-later
// The crest: the level edges at the highest point of what can move, over which a pool may flow.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

struct CrestEdge {
  int block;
  int edge;
  double left_m;
  double right_m;
};

struct Crest {
  double height_m;               ///< of the highest point; minus infinity if nothing can move
  std::vector<CrestEdge> edges;  ///< none where the structure ends in a point, or in an edge that slopes
};

/// `outlines`: of all blocks, where they are [m]. An edge is level if both of its ends are as high as the highest point
/// but for 0.002 of the height of all blocks, by which the still water tells the crest, too.
Crest crest_of(const std::vector<Block>& blocks, const std::vector<std::vector<Point>>& outlines);

/// Of the blocks as they are drawn.
Crest crest_of(const std::vector<Block>& blocks);

}  // namespace blockweir::scene
