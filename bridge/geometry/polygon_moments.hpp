// SPDX-License-Identifier: GPL-3.0-or-later
// Exact area, centroid and second moments of a simple polygon, for the area integrals of (5)-(6).
#pragma once

#include <span>

#include "bridge/geometry/point.hpp"

namespace blockweir::geometry {

/// Moments of a counter-clockwise outline; second moments about the centroid.
struct PolygonMoments {
  double area = 0;  ///< m2
  Point centroid;   ///< m
  double xx = 0;    ///< integral of X^2 [m4]
  double yy = 0;    ///< integral of Y^2 [m4]
  double xy = 0;    ///< integral of X Y [m4]
};

/// Sums over the triangles (centroid, i, i+1), so that a polygon far from the origin loses no digits.
PolygonMoments polygon_moments(std::span<const Point> outline);

}  // namespace blockweir::geometry
