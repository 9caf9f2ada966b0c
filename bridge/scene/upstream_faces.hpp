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

}  // namespace blockweir::scene
