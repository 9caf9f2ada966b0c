// SPDX-License-Identifier: GPL-3.0-or-later
// Area and centroid of a simple polygon, exact to round-off.
#pragma once

#include <span>

#include "bridge/geometry/point.hpp"

namespace blockweir::geometry {

/// Signed area [m2], positive for counter-clockwise outlines.
double signed_area(std::span<const Point> outline);

/// Centroid [m]. Sums are taken about the first vertex, so polygons far from the origin lose no digits.
Point centroid(std::span<const Point> outline);

}  // namespace blockweir::geometry
