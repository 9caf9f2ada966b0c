// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/geometry/polygon_moments.hpp"

#include "bridge/scene/polygon.hpp"

namespace blockweir::solid {

PolygonMoments polygon_moments(std::span<const Eigen::Vector2d> outline) {
  PolygonMoments m;
  m.centroid = scene::centroid(outline);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d p = outline[i] - m.centroid;
    const Eigen::Vector2d q = outline[(i + 1) % outline.size()] - m.centroid;
    const double cross = p.x() * q.y() - p.y() * q.x();
    m.area += cross / 2;
    m.xx += cross / 12 * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
    m.yy += cross / 12 * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y());
    m.xy += cross / 24 * (2 * p.x() * p.y() + p.x() * q.y() + q.x() * p.y() + 2 * q.x() * q.y());
  }
  return m;
}

}  // namespace blockweir::solid
