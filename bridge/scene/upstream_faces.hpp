// SPDX-License-Identifier: GPL-3.0-or-later
// What of the blocks that can move is seen from upstream, looking level.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A part of one edge that no other block stands before.
struct UpstreamFace {
  int block = 0;
  Point top_m;
  Point bottom_m;
};

std::vector<UpstreamFace> upstream_faces(const Scene& scene, double below_m);

/// A part of a level edge that looks up, from left to right, and that no block stands on or before.
struct UpstreamFloor {
  int block = 0;
  Point left_m;
  Point right_m;
};

std::vector<UpstreamFloor> upstream_floors(const Scene& scene, double below_m);

}  // namespace blockweir::scene
