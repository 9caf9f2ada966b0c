// SPDX-License-Identifier: GPL-3.0-or-later
// What the search for contacts asks of the corners of an outline.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "solid/block/block.hpp"
#include "solid/block/motion.hpp"

namespace blockweir::solid {

constexpr double parallel_tolerance = 0.05;  // rad; edges closer in direction than this lie on each other

using geometry::cross;

inline std::size_t next(std::size_t i, std::size_t count) {
  return i + 1 == count ? 0 : i + 1;
}
inline std::size_t previous(std::size_t i, std::size_t count) {
  return i == 0 ? count - 1 : i - 1;
}

/// Does the body take up more than half of the plane at this corner of its outline?
inline bool reflex(const std::vector<Point>& outline, std::size_t v) {
  const Point before = outline[previous(v, outline.size())] - outline[v];
  const Point after = outline[next(v, outline.size())] - outline[v];
  return cross(after.normalized(), before.normalized()) < -parallel_tolerance;
}

/// Is the body at this corner of an outline on the normal's side of it, but for an angle of `closing` [rad]? A vertex
/// presses on no other edges. Both sides of a corner that is nearly straight, or very sharp, lie along the edge
/// whichever side the body is on: the way into the body tells, but for an angle of `turning` [rad]:
/// the tip of a needle may turn onto a face that it is still off, and that its axis points away from.
/// `to_before`, `to_after`: of unit length, from the corner along its sides.
inline bool faces(const Point& to_before, const Point& to_after, const Point& normal, double closing, double turning) {
  if (std::min(normal.dot(to_before), normal.dot(to_after)) < -closing) return false;
  const Point inward = perpendicular(to_after) - perpendicular(to_before);
  return normal.dot(inward) >= -turning * inward.norm();
}
inline bool faces(const std::vector<Point>& outline, std::size_t v, const Point& normal, double closing) {
  const Point to_before = (outline[previous(v, outline.size())] - outline[v]).normalized();
  const Point to_after = (outline[next(v, outline.size())] - outline[v]).normalized();
  return faces(to_before, to_after, normal, closing, 0);
}

/// Does the outline enclose the point? Edges that cross its height on its right are counted.
inline bool encloses(const std::vector<Point>& outline, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[next(i, outline.size())];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x()) inside = !inside;
  }
  return inside;
}

/// Does the body at this corner of an outline reach through an edge of another from its outside, by more than `least`?
/// Where the other ends in an acute corner it may come out again on its far side.
inline bool pierces(const std::vector<Point>& outline, std::size_t v, const std::vector<Point>& other, std::size_t edge,
                    double least) {
  const Point& from = other[edge];
  const Point span = other[next(edge, other.size())] - from;
  const double length = span.norm();
  const Point t = span / length;
  const auto outside = [&](const Point& p) { return cross(p - from, t); };
  const double depth = -outside(outline[v]);
  if (depth <= least) return false;
  const auto crosses = [&](std::size_t w) {
    const double rest = outside(outline[w]);
    if (rest <= least) return false;
    const double s = t.dot(outline[v] + depth / (depth + rest) * (outline[w] - outline[v]) - from);
    return s > least && s < length - least;
  };
  return crosses(previous(v, outline.size())) || crosses(next(v, outline.size()));
}

}  // namespace blockweir::solid
