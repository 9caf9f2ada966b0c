// SPDX-License-Identifier: GPL-3.0-or-later
// The point where one segment crosses another.
#pragma once

#include <optional>

#include "bridge/geometry/point.hpp"

namespace blockweir::geometry {

/// Position of the crossing with c-d along a-b, as a fraction 0..1, ends included; none if they are parallel or apart.
inline std::optional<double> crossing(const Segment& a_b, const Segment& c_d) {
  const auto side = [](const Segment& s, const Point& p) { return cross(s.to - s.from, p - s.from); };
  const double from = side(c_d, a_b.from);
  const double to = side(c_d, a_b.to);
  if (from == to || from * to > 0 || side(a_b, c_d.from) * side(a_b, c_d.to) > 0) return std::nullopt;
  return from / (from - to);
}

}  // namespace blockweir::geometry
