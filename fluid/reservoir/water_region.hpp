// SPDX-License-Identifier: GPL-3.0-or-later
// The section of a body of water: corners, far ends, and the points of its boundary that belong to blocks.
#pragma once

#include <optional>
#include <vector>

#include "fluid/hydrostatic/pools.hpp"

namespace blockweir::reservoir {

using geometry::Point;
using hydrostatic::Ring;

/// Where the water ends beyond the model, if it does not end at a block.
struct FarEnd {
  double x_m = 0;
  bool wall = false;                     ///< of the ground; else the water goes on
  std::optional<double> absorbs_from_m;  ///< x from which waves are damped, so that none comes back
};

struct FarEnds {
  FarEnd left;
  FarEnd right;
};

/// The blocks that border the water.
struct Banks {
  const std::vector<std::vector<Point>>& outlines;  ///< of all blocks, where they are now
  std::vector<Point> corners = {};                  ///< mesh corners on faces
  Point ground_m = Point::Zero();                   ///< how far the ground is from where the scene draws it
};

/// Least and largest x.
struct Extent {
  double left_m;
  double right_m;
};
Extent extent_of(const std::vector<Ring>& rings);

/// Height of the surface over the lowest point of the body [m].
double depth(const hydrostatic::WaterBody& body);

/// Points nearer to each other are one [m].
double same_place_m(const hydrostatic::WaterBody& body);

/// The body's region in corners, its ends in open water moved to the far ends. A wall may stand on the blocks' own end:
/// what water there is beyond ends at it.
std::vector<Ring> region_of(const hydrostatic::WaterBody& body, const Banks& banks, const FarEnds& far);

/// The same region where rings cross, as banks do that part or close by a rounding: without water, and without ground
/// in water, that is narrower than twice width_m, and without water that this cuts off from the surface.
std::vector<Ring> without_crossings(const std::vector<Ring>& rings, const hydrostatic::WaterBody& body, double width_m);

/// Two points a wet face, where it begins and ends: what one block does to the water stops there.
std::vector<Point> ends_of_faces(const hydrostatic::WaterBody& body, const Banks& banks);

/// The ring with those of `points` that lie on its sides.
Ring with_points(const Ring& ring, const std::vector<Point>& points, double tiny_m);

}  // namespace blockweir::reservoir
