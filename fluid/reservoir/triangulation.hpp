// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a region, whose sides grow with the distance from given points.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "fluid/joints/water_grid.hpp"

namespace blockweir::reservoir {

using geometry::Point;
using joints::Ring;

/// A side of a triangle is at most min(widest, at_point + growth times the distance from the nearest point) [m]. Left
/// and right of an inner part, widest grows with the distance from it, to `outermost`.
struct Sizes {
  std::vector<Point> points;
  double at_point_m = 0;
  double widest_m = 0;
  double growth = 0;
  double inner_left_m = -std::numeric_limits<double>::infinity();
  double inner_right_m = std::numeric_limits<double>::infinity();
  double outermost_m = 0;
};

struct Triangulated {
  std::vector<Point> node;
  std::vector<std::array<int, 3>> triangle;  ///< counter-clockwise
};

/// Delaunay refinement of what the rings enclose, holes among them. None where rings cross.
std::optional<Triangulated> triangulate(const std::vector<Ring>& rings, const Sizes& sizes);

}  // namespace blockweir::reservoir
