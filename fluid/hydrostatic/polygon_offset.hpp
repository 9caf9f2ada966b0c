// SPDX-License-Identifier: GPL-3.0-or-later
// Closed lines moved sideways: blocks grow until narrow gaps between them close, and what bounds the rest moves back.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::hydrostatic {

using scene::Point;

/// A closed line; the outer ones run counter-clockwise, holes clockwise.
using Ring = std::vector<Point>;

/// `outline`, counter-clockwise, with every edge moved out by `distance_m`. Corners that turn by up to 140 degrees are
/// mitred, so that they come back to where they were also where other blocks lie beside them; sharper ones are cut off
/// as far out as their edges have moved, so that they do, too; reflex ones are mitred. Where a reflex corner's edges
/// are too short for that, the line visits the corner itself: it makes a loop there that runs clockwise, so what lies
/// inside has a positive winding number.
Ring grown(const Ring& outline, double distance_m);

struct Piece {
  Point from;
  Point to;
};

/// The edges of `ring`, edge i from vertex i to the next moved to its right by right_m[i], lengthened or shortened to
/// where they meet, but by no more than ten times that distance. Those that would turn round are left out.
std::vector<Piece> moved_right(const Ring& ring, const std::vector<double>& right_m);

}  // namespace blockweir::hydrostatic
