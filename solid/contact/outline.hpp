// SPDX-License-Identifier: GPL-3.0-or-later
// What the search for contacts asks of the corners of an outline.
#pragma once

#include <cstddef>
#include <vector>

#include "solid/block/block.hpp"

namespace blockweir::solid {

constexpr double parallel_tolerance = 0.05;  // rad; edges closer in direction than this lie on each other

inline double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

inline std::size_t next(std::size_t i, std::size_t count) {
  return i + 1 == count ? 0 : i + 1;
}
inline std::size_t previous(std::size_t i, std::size_t count) {
  return i == 0 ? count - 1 : i - 1;
}

/// Is the body at this corner of an outline on the normal's side of it, but for an angle of `closing` [rad]? A vertex
/// presses on no other edges.
inline bool faces(const std::vector<Point>& outline, std::size_t v, const Point& normal, double closing) {
  const auto beyond = [&](std::size_t w) { return normal.dot((outline[w] - outline[v]).normalized()) >= -closing; };
  return beyond(previous(v, outline.size())) && beyond(next(v, outline.size()));
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

}  // namespace blockweir::solid
