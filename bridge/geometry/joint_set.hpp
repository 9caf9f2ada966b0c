// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel joints with a dip, a spacing and a persistence, drawn from a seed.
#pragma once

#include <cstdint>
#include <span>

#include "bridge/geometry/cut.hpp"

namespace blockweir::geometry {

struct JointSet {
  double dip_deg = 0;            ///< below the horizontal, downstream; -90 to 90
  double spacing_m = 1;          ///< between neighbouring joints, square to them
  double offset_m = 0;           ///< of one of them from the origin, square to them, upwards
  double persistence = 1;        ///< joint length over all length along a joint; 1: no bridges
  double trace_length_m = 0;     ///< of one stretch of joint between two bridges; of no account without bridges
  double spacing_deviation = 0;  ///< joints move by up to this share of half a spacing, at random
  std::uint64_t seed = 1;
};

/// The joints that cross the box from `low` to `high`, as lines with this id. The same seed gives the same joints on
/// every machine.
std::vector<Line> joints_of(const JointSet& set, const Point& low, const Point& high, int id);

/// The parts of a line of two points that lie within an outline, each longer by `beyond_m` at both ends so that it
/// meets the outline whatever rounding does.
std::vector<Line> parts_within(const Line& line, std::span<const Point> outline, double beyond_m);

}  // namespace blockweir::geometry
