// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/polygon_moments.hpp"

#include "bridge/geometry/polygon.hpp"

namespace blockweir::geometry {

PolygonMoments polygon_moments(std::span<const Point> outline) {
  PolygonMoments m;
  m.centroid = centroid(outline);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point p = outline[i] - m.centroid;
    const Point q = outline[(i + 1) % outline.size()] - m.centroid;
    const double twice = cross(p, q);
    m.area += twice / 2;
    m.xx += twice / 12 * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
    m.yy += twice / 12 * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y());
    m.xy += twice / 24 * (2 * p.x() * p.y() + p.x() * q.y() + q.x() * p.y() + 2 * q.x() * q.y());
  }
  return m;
}

}  // namespace blockweir::geometry
