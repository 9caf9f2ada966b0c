// SPDX-License-Identifier: GPL-3.0-or-later
// The area of a mesh cell that a block fills. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::openfoam {

using geometry::cross;
using geometry::Point;
using Polygon = std::vector<Point>;

/// Signed area [m2], positive for a counter-clockwise outline.
inline double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    const Point& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    twice += cross(p, q);
  }
  return twice / 2;
}

/// Sutherland and Hodgman's clipping, with reused storage. Parts of a concave polygon may stay connected by edges that
/// run to and fro; these enclose no area.
class PolygonClip {
 public:
  /// Area [m2] common to both: `subject` any simple outline, `window` convex, both counter-clockwise.
  double common_area(const Polygon& subject, const Polygon& window) {
    from_ = subject;
    for (std::size_t i = 0; i < window.size() && !from_.empty(); ++i) {
      keep_left_of(window[i], window[i + 1 < window.size() ? i + 1 : 0]);
      from_.swap(to_);
    }
    return from_.empty() ? 0 : area(from_);
  }

 private:
  void keep_left_of(const Point& a, const Point& b) {
    to_.clear();
    const auto side = [&](const Point& p) { return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x(); };
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const Point& p = from_[i];
      const Point& q = from_[i + 1 < from_.size() ? i + 1 : 0];
      const double at_p = side(p);
      const double at_q = side(q);
      if (at_p >= 0) to_.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) to_.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
  }

  Polygon from_;
  Polygon to_;
};

}  // namespace blockweir::openfoam
