// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel joints with a dip, a spacing and a persistence, drawn at random from a seed.
#pragma once

#include <cstdint>
#include <span>

#include "bridge/geometry/cut.hpp"

namespace blockweir::geometry {

struct JointSet {
  double dip_deg = 0;            ///< below the horizontal, downstream; -90 to 90
  double spacing_m = 1;          ///< between neighbouring joints, perpendicular to them
  double offset_m = 0;           ///< distance of one joint from the origin, perpendicular to the joints, upwards
  double persistence = 1;        ///< share of a joint's length that is open to slip; 1: no rock bridges
  double trace_length_m = 0;     ///< length of joint between two rock bridges; unused without bridges
  double spacing_deviation = 0;  ///< each joint is moved at random by up to this share of half the spacing
  std::uint64_t seed = 1;
};

/// The joints that cross the box from `low` to `high`, as lines with this id. The same seed gives the same joints on
/// every machine.
std::vector<Line> joints_of(const JointSet& set, const Point& low, const Point& high, int id);

/// The parts of a two-point line inside an outline. Each is extended by `beyond_m` at both ends, so that it crosses the
/// outline in spite of round-off.
std::vector<Line> parts_within(const Line& line, std::span<const Point> outline, double beyond_m);

}  // namespace blockweir::geometry
