// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of moving blocks that are visible from upstream along horizontal lines.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A part of an edge with no other block in front of it.
struct UpstreamFace {
  int block = 0;
  Point top_m;
  Point bottom_m;
};

std::vector<UpstreamFace> upstream_faces(const Scene& scene, double below_m);

/// A part of a horizontal edge that faces up, from left to right, with no block on it or in front of it.
struct UpstreamFloor {
  int block = 0;
  Point left_m;
  Point right_m;
};

std::vector<UpstreamFloor> upstream_floors(const Scene& scene, double below_m);

}  // namespace blockweir::scene
