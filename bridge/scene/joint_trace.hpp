// SPDX-License-Identifier: GPL-3.0-or-later
// The common boundary of two blocks as drawn: the line of a joint.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A straight part of it, with the fractions 0..1 of edge_a of block a and edge_b of block b at `from_m` and `to_m`.
struct TracePiece {
  int edge_a = 0;
  int edge_b = 0;
  double s_from_a = 0;
  double s_to_a = 0;
  double s_from_b = 0;
  double s_to_b = 0;
  Point from_m;
  Point to_m;
};

/// Pieces in order, starting at the upstream end (smallest x; of equal x the highest).
struct JointTrace {
  std::vector<TracePiece> pieces;
  double length_m = 0;

  [[nodiscard]] const Point& mouth() const { return pieces.front().from_m; }
  [[nodiscard]] const Point& end() const { return pieces.back().to_m; }
};

/// Empty if the blocks do not touch; edges closer than `tolerance_m` count as touching.
JointTrace trace_joint(const Block& a, const Block& b, double tolerance_m);

}  // namespace blockweir::scene
