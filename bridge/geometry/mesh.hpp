// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that fill a block: constrained Delaunay refinement. It records which triangle sides lie on the outline.
#pragma once

#include <array>
#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::geometry {

/// A triangle side on the outline, from corner `side` to the next.
struct BoundarySide {
  int triangle = 0;
  int side = 0;
  int edge = 0;       ///< of the outline
  double s_from = 0;  ///< fractions of that edge
  double s_to = 1;
};

struct Mesh {
  std::vector<Point> nodes;                   ///< m
  std::vector<std::array<int, 3>> triangles;  ///< nodes, counter-clockwise
  std::vector<BoundarySide> boundary;         ///< all along the outline, from its first vertex
};

/// Triangulates a simple counter-clockwise outline with sides of about `size_m` at most. Every run gives the same mesh.
Mesh triangulate(const std::vector<Point>& outline, double size_m);

}  // namespace blockweir::geometry
