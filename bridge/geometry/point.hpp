// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace blockweir::geometry {

using Point = Eigen::Vector2d;  ///< m; x downstream, y up

struct Segment {
  Point from;
  Point to;
};

/// Positive if b is counter-clockwise of a.
inline double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace blockweir::geometry
