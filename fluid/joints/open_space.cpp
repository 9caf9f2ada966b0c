// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/open_space.hpp"

#include <algorithm>

#include "bridge/geometry/outline.hpp"
#include "fluid/joints/water_grid.hpp"

namespace blockweir::joints {

OpenSpace::OpenSpace(const std::vector<std::vector<Point>>& outlines, double open_m) {
  Extent all;
  for (const std::vector<Point>& outline : outlines) {
    for (const Point& p : outline) all.extend(p);
  }
  const Grid grid(all);
  ClipperLib::Clipper clipper;
  for (const std::vector<Point>& outline : outlines) {
    clipper.AddPath(grid.units(grown(outline, open_m / 2)), ClipperLib::ptSubject, true);
  }
  ClipperLib::PolyTree grown_together;
  clipper.Execute(ClipperLib::ctUnion, grown_together, ClipperLib::pftPositive, ClipperLib::pftPositive);
  for (const ClipperLib::PolyNode* body : grown_together.Childs) {
    Ring& shore = shores_.emplace_back();
    for (const ClipperLib::IntPoint& p : body->Contour) shore.push_back(grid.metres(p));
  }
}

bool OpenSpace::reaches(const Point& p, double near_m) const {
  return std::any_of(shores_.begin(), shores_.end(), [&](const Ring& shore) {
    for (std::size_t i = 0; i < shore.size(); ++i) {
      if (geometry::distance_to_segment(p, shore[i], shore[(i + 1) % shore.size()]) <= near_m) return true;
    }
    return false;
  });
}

}  // namespace blockweir::joints
