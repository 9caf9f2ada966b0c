// SPDX-License-Identifier: GPL-3.0-or-later
// Offsets polygons: blocks grow until narrow gaps between them close; the boundary of the water left moves back.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::joints {

using scene::Point;

/// A closed line; the outer ones run counter-clockwise, holes clockwise.
using Ring = std::vector<Point>;

/// Moves every edge of the counter-clockwise `outline` out by `distance_m`. Corners that turn by up to 140 degrees are
/// mitred; sharper ones are cut off at the distance by which their edges have moved. In both cases they return to their
/// place when moved back, also with other blocks beside them. Reflex corners are mitred. If a reflex corner's edges are
/// too short for that, the line passes through the corner itself and makes a clockwise loop there, so that the inside
/// has a positive winding number.
Ring grown(const Ring& outline, double distance_m);

struct Piece {
  Point from;
  Point to;
};

/// Moves edge i of `ring`, from vertex i to the next, to its right by right_m[i]. Edges are lengthened or shortened to
/// their intersection, but by no more than ten times that distance. Edges that would reverse are left out.
std::vector<Piece> moved_right(const Ring& ring, const std::vector<double>& right_m);

}  // namespace blockweir::joints
