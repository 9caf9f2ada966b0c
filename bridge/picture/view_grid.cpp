// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/view_grid.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::picture {

namespace cl = ClipperLib;
using Point = Eigen::Vector2d;

ViewGrid::ViewGrid(const View& view)
    : origin_(view.left, view.bottom), per_m_(1e8 / std::max(view.right - view.left, view.top - view.bottom)) {}

cl::IntPoint ViewGrid::on(const Point& p) const {
  const Point q = per_m_ * (p - origin_);
  return {std::llround(q.x()), std::llround(q.y())};
}

Point ViewGrid::metres(const cl::IntPoint& p) const {
  return origin_ + Point(static_cast<double>(p.X), static_cast<double>(p.Y)) / per_m_;
}

std::vector<std::vector<Point>> in_view(const std::vector<Point>& outline, const View& view) {
  const bool whole_is_seen = std::all_of(outline.begin(), outline.end(), [&](const Point& p) {
    return p.x() >= view.left && p.x() <= view.right && p.y() >= view.bottom && p.y() <= view.top;
  });
  if (whole_is_seen) return {outline};
  const ViewGrid grid(view);
  cl::Path whole;
  for (const Point& p : outline) whole.push_back(grid.on(p));
  const cl::Path window = {grid.on({view.left, view.bottom}), grid.on({view.right, view.bottom}),
                           grid.on({view.right, view.top}), grid.on({view.left, view.top})};
  cl::Clipper clipper;
  clipper.AddPath(whole, cl::ptSubject, true);
  clipper.AddPath(window, cl::ptClip, true);
  cl::Paths seen;
  clipper.Execute(cl::ctIntersection, seen, cl::pftNonZero, cl::pftNonZero);
  std::vector<std::vector<Point>> pieces;
  for (const cl::Path& path : seen) {
    auto& piece = pieces.emplace_back();
    for (const cl::IntPoint& p : path) piece.push_back(grid.metres(p));
  }
  return pieces;
}

}  // namespace blockweir::picture
