// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/still_pools.hpp"

#include <algorithm>
#include <limits>

#include "bridge/picture/view_grid.hpp"

namespace blockweir::picture {
namespace {

namespace cl = ClipperLib;
using nlohmann::json;
using Point = Eigen::Vector2d;

/// Where the water of a frame presses, cracks apart.
struct WetPoints {
  std::vector<Point> middles;  ///< of the faces
  View all;
  /// The lowest point at the left end of all, and at the right: beyond them the bed is level.
  double foot_left = std::numeric_limits<double>::infinity();
  double foot_right = std::numeric_limits<double>::infinity();

  explicit WetPoints(const json& frame) {
    std::vector<Point> ends;
    for (const json& panel : frame["panels"]) {
      const bool in_crack = panel.at(6) != 0;
      if (in_crack) continue;
      for (const std::size_t i : {0U, 2U}) ends.emplace_back(panel[i].get<double>(), panel[i + 1].get<double>());
      middles.emplace_back((ends[ends.size() - 2] + ends.back()) / 2);
    }
    for (const Point& p : ends) all.include(p.x(), p.y());
    const double near = 1e-6 * (all.right - all.left);
    for (const Point& p : ends) {
      if (p.x() <= all.left + near) foot_left = std::min(foot_left, p.y());
      if (p.x() >= all.right - near) foot_right = std::min(foot_right, p.y());
    }
  }
};

double crest_x(const json& frame) {
  double x = 0;
  double y = -std::numeric_limits<double>::infinity();
  for (const json& block : frame["blocks"]) {
    for (const json& p : block["outline"]) {
      if (block["fixed"].get<bool>() || p[1].get<double>() <= y + 1e-3) continue;
      x = p[0];
      y = p[1];
    }
  }
  return x;
}

double highest_point(const json& frame) {
  double y = -std::numeric_limits<double>::infinity();
  for (const json& block : frame["blocks"]) {
    for (const json& p : block["outline"]) y = std::max(y, p[1].get<double>());
  }
  return y;
}

/// Whether a moving block is in view. Otherwise only the level limits the height of the water.
bool shows_movable(const json& frame, const View& view) {
  for (const json& block : frame["blocks"]) {
    if (block["fixed"].get<bool>()) continue;
    View box;
    for (const json& p : block["outline"]) box.include(p[0], p[1]);
    if (box.right > view.left && box.left < view.right && box.top > view.bottom && box.bottom < view.top) return true;
  }
  return false;
}

/// All that may be a pool, as boxes up to the levels.
cl::Paths under_levels(const json& frame, const WetPoints& wet, const View& view, const ViewGrid& grid) {
  cl::Paths boxes;
  const double highest = shows_movable(frame, view) ? std::min(view.top, highest_point(frame)) : view.top;
  const auto add = [&](double from, double to, double bottom, double level) {
    from = std::max(from, view.left);
    to = std::min(to, view.right);
    bottom = std::max(bottom, view.bottom);
    level = std::min(level, highest);
    if (from >= to || bottom >= level) return;
    boxes.push_back({grid.on({from, bottom}), grid.on({to, bottom}), grid.on({to, level}), grid.on({from, level})});
  };
  const double crest = crest_x(frame);
  const bool both = frame["upstream_level_m"].is_number() && frame["downstream_level_m"].is_number();
  if (frame["upstream_level_m"].is_number()) {
    const double level = frame["upstream_level_m"];
    const double inner = both ? crest : wet.all.right;  // one pool alone ends where its last wet face does
    const double end = wet.foot_left == wet.all.bottom ? view.left : std::min(inner, wet.all.left);
    add(view.left, end, wet.foot_left, level);
    add(end, inner, wet.all.bottom, level);
  }
  if (frame["downstream_level_m"].is_number()) {
    const double level = frame["downstream_level_m"];
    const double inner = both ? crest : wet.all.left;
    const double end = wet.foot_right == wet.all.bottom ? view.right : std::max(inner, wet.all.right);
    add(inner, end, wet.all.bottom, level);
    add(end, view.right, wet.foot_right, level);
  }
  return boxes;
}

cl::Paths grown_blocks(const json& frame, const ViewGrid& grid) {
  cl::ClipperOffset offset;
  for (const json& block : frame["blocks"]) {
    cl::Path outline;
    for (const json& p : block["outline"]) outline.push_back(grid.on({p[0].get<double>(), p[1].get<double>()}));
    offset.AddPath(outline, cl::jtMiter, cl::etClosedPolygon);
  }
  cl::Paths grown;
  offset.Execute(grown, ViewGrid::closed / 2);
  return grown;
}

double distance_to(const cl::Path& outline, const cl::IntPoint& place) {
  const auto point = [](const cl::IntPoint& p) { return Point(static_cast<double>(p.X), static_cast<double>(p.Y)); };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point from = point(outline[i]);
    const Point span = point(outline[(i + 1) % outline.size()]) - from;
    const double share = std::clamp(span.dot(point(place) - from) / std::max(span.squaredNorm(), 1.0), 0.0, 1.0);
    least = std::min(least, (from + share * span - point(place)).norm());
  }
  return least;
}

}  // namespace

bool above_all(const json& frame) {
  for (const char* pool : {"upstream_level_m", "downstream_level_m"}) {
    if (frame[pool].is_number() && frame[pool].get<double>() > highest_point(frame)) return true;
  }
  return false;
}

std::vector<std::vector<Point>> still_pools(const json& frame, const View& view) {
  const WetPoints wet(frame);
  if (wet.middles.empty()) return {};
  const ViewGrid grid(view);
  cl::Clipper clipper;
  clipper.AddPaths(under_levels(frame, wet, view, grid), cl::ptSubject, true);
  clipper.AddPaths(grown_blocks(frame, grid), cl::ptClip, true);
  cl::Paths open;
  clipper.Execute(cl::ctDifference, open, cl::pftNonZero, cl::pftNonZero);
  std::vector<std::vector<Point>> pools;
  for (const cl::Path& outline : open) {
    const bool is_wet = std::any_of(wet.middles.begin(), wet.middles.end(), [&](const Point& middle) {
      return distance_to(outline, grid.on(middle)) <= ViewGrid::closed;
    });
    if (!is_wet || !cl::Orientation(outline)) continue;  // a hole is a block, which is drawn over the water
    auto& pool = pools.emplace_back();
    for (const cl::IntPoint& p : outline) pool.push_back(grid.metres(p));
  }
  return pools;
}

}  // namespace blockweir::picture
