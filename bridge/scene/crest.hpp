// SPDX-License-Identifier: GPL-3.0-or-later
// The crest: the level edges at the highest point of what can move and stands on the ground, over which a pool may
// flow.
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

/// Points count as high as the highest one but for 0.002 of the height of all blocks, by which the still water tells
/// the crest, too.
struct Crest {
  double height_m;  ///< of the highest point; minus infinity if nothing can move
  double low_m;     ///< from which on a point is as high
  double left_m;    ///< of those points the extent
  double right_m;
  std::vector<CrestEdge> edges;  ///< both ends as high; none where the structure ends in a point, or slopes there
};

/// `outlines`: of all blocks, where they are [m].
Crest crest_of(const std::vector<Block>& blocks, const std::vector<std::vector<Point>>& outlines);

/// Of the blocks as they are drawn.
Crest crest_of(const std::vector<Block>& blocks);

}  // namespace blockweir::scene
