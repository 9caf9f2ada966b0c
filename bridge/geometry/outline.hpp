// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of blocks: faults of an outline, and points on or inside it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "bridge/geometry/point.hpp"

namespace blockweir::geometry {

/// Axis-parallel box around points [m].
struct Bounds {
  Point low;
  Point high;
  [[nodiscard]] double size() const { return (high - low).maxCoeff(); }
};
/// `points` must not be empty.
Bounds bounds_of(std::span<const Point> points);

Point nearest_on_segment(const Point& p, const Point& from, const Point& to);
double distance_to_segment(const Point& p, const Point& from, const Point& to);

/// Why an outline of three or more points does not enclose an area exactly once.
struct OutlineFault {
  std::size_t vertex = 0;  ///< where the fault is
  std::string found;       ///< printed after the block's name: "has the vertex (0, 0) twice"
  std::string expected;
  std::string remedy;
};
/// The first fault. Lengths below 1e-9 of the outline's size count as zero.
std::optional<OutlineFault> outline_fault(std::span<const Point> outline);

/// Whether p lies inside a valid outline, or within `tolerance_m` of it.
bool holds_point(std::span<const Point> outline, const Point& p, double tolerance_m);

/// Whether one edge passes within `tolerance_m` of both points.
bool on_one_edge(std::span<const Point> outline, const Point& p, const Point& q, double tolerance_m);

}  // namespace blockweir::geometry
