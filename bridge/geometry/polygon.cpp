// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/polygon.hpp"

namespace blockweir::geometry {
namespace {

/// Calls visit(p, q, p x q) for each edge, with the first vertex as origin.
template <class Visit>
void each_edge(std::span<const Point> outline, Visit visit) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point p = outline[i] - outline[0];
    const Point q = outline[(i + 1) % outline.size()] - outline[0];
    visit(p, q, cross(p, q));
  }
}

}  // namespace

double signed_area(std::span<const Point> outline) {
  double twice = 0;
  each_edge(outline, [&](const Point&, const Point&, double area) { twice += area; });
  return twice / 2;
}

Point centroid(std::span<const Point> outline) {
  double twice = 0;
  Point moment = Point::Zero();
  each_edge(outline, [&](const Point& p, const Point& q, double area) {
    twice += area;
    moment += area * (p + q);
  });
  return outline[0] + moment / (3 * twice);
}

}  // namespace blockweir::geometry
