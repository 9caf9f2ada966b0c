// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/wet_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <polyclipping/clipper.hpp>

namespace blockweir::hydrostatic {
namespace {

namespace cl = ClipperLib;
constexpr double units_per_m = 1099511627776.0;  // 2^40: Clipper counts in whole numbers, of 1e-12 m here
constexpr double tiny_m = 1e-6;                  // shorter than anything that matters, longer than round-off

cl::IntPoint to_units(const Point& p) {
  return {static_cast<cl::cInt>(std::llround(p.x() * units_per_m)),
          static_cast<cl::cInt>(std::llround(p.y() * units_per_m))};
}

Point to_metres(const cl::IntPoint& p) {
  return {static_cast<double>(p.X) / units_per_m, static_cast<double>(p.Y) / units_per_m};
}

cl::Path rectangle(double left, double bottom, double right, double top) {
  return {to_units({left, bottom}), to_units({right, bottom}), to_units({right, top}), to_units({left, top})};
}

cl::Paths offset(const cl::Paths& paths, double distance_m) {
  cl::ClipperOffset tool(/*miterLimit=*/10);
  tool.AddPaths(paths, cl::jtMiter, cl::etClosedPolygon);
  cl::Paths result;
  tool.Execute(result, distance_m * units_per_m);
  return result;
}

struct Extent {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
};

Extent extent_of(const std::vector<std::vector<Point>>& outlines) {
  Extent e;
  for (const auto& outline : outlines) {
    for (const Point& p : outline) {
      e.left = std::min(e.left, p.x());
      e.right = std::max(e.right, p.x());
      e.bottom = std::min(e.bottom, p.y());
      e.top = std::max(e.top, p.y());
    }
  }
  return e;
}

/// The crest's corner on the pool's side: of all vertices that are as high as the highest but for `tolerance_m` the
/// one nearest to the pool, so that a crest which tilts a little as the block moves stays the same crest.
Point crest_corner(const std::vector<std::vector<Point>>& outlines, Pool pool, double top, double tolerance_m) {
  Point corner(
      pool == Pool::upstream ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity(), 0);
  for (const auto& outline : outlines) {
    for (const Point& p : outline) {
      const bool nearer = pool == Pool::upstream ? p.x() < corner.x() : p.x() > corner.x();
      if (p.y() >= top - tolerance_m && nearer) corner = p;
    }
  }
  return corner;
}

/// Blocks with their narrow gaps filled: outlines of all that water cannot enter.
cl::Paths impervious(const std::vector<std::vector<Point>>& outlines, double open_crack_width_m) {
  cl::Paths blocks;
  for (const auto& outline : outlines) {
    cl::Path path;
    for (const Point& p : outline) path.push_back(to_units(p));
    blocks.push_back(std::move(path));
  }
  cl::Paths merged;
  cl::Clipper union_of;
  union_of.AddPaths(blocks, cl::ptSubject, true);
  union_of.Execute(cl::ctUnion, merged, cl::pftNonZero, cl::pftNonZero);
  cl::Paths closed = offset(offset(merged, open_crack_width_m / 2), -open_crack_width_m / 2);
  closed.insert(closed.end(), merged.begin(), merged.end());
  return closed;
}

/// Adds the parts of the pool's boundary a-b that lie on edges of blocks. Filling the gaps moves the boundary by less
/// than `near_m` where blocks have slipped a little past each other.
void map_to_edges(const std::vector<std::vector<Point>>& outlines, const Point& a, const Point& b, double near_m,
                  std::vector<WetInterval>& intervals) {
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const auto& outline = outlines[k];
    for (std::size_t e = 0; e < outline.size(); ++e) {
      const Point& p = outline[e];
      const Point span = outline[(e + 1) % outline.size()] - p;
      const double length = span.norm();
      const Point t = span / length;
      const auto away = [&](const Point& q) { return std::abs(t.x() * (q - p).y() - t.y() * (q - p).x()); };
      const bool parallel = std::abs(t.dot(b - a)) > 0.99 * (b - a).norm();
      if (!parallel || away(a) > near_m || away(b) > near_m) continue;
      const auto [s0, s1] = std::minmax({t.dot(a - p) / length, t.dot(b - p) / length});
      const double from = std::max(0.0, s0);
      const double to = std::min(1.0, s1);
      if ((to - from) * length > tiny_m) intervals.push_back({static_cast<int>(k), static_cast<int>(e), from, to});
    }
  }
}

/// The exact value that `s` stands for: an end of the edge, the water surface, or itself when neither is near.
double exact_end(double s, double surface, double tolerance) {
  double best = s;
  double distance = tolerance;
  for (const double candidate : {0.0, 1.0, surface}) {
    if (std::abs(s - candidate) >= distance) continue;
    distance = std::abs(s - candidate);
    best = candidate;
  }
  return std::clamp(best, 0.0, 1.0);
}

/// Puts the ends of intervals where they belong, and joins what overlaps.
void tidy(const std::vector<std::vector<Point>>& outlines, double level_m, double near_m,
          std::vector<WetInterval>& intervals) {
  const auto key = [](const WetInterval& w) { return std::make_tuple(w.block, w.edge, w.s_from); };
  std::sort(intervals.begin(), intervals.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::vector<WetInterval> joined;
  for (WetInterval w : intervals) {
    const auto& outline = outlines[static_cast<std::size_t>(w.block)];
    const Point& p = outline[static_cast<std::size_t>(w.edge)];
    const Point span = outline[(static_cast<std::size_t>(w.edge) + 1) % outline.size()] - p;
    const double tolerance = near_m / span.norm();
    const double surface = std::abs(span.y()) > tiny_m ? (level_m - p.y()) / span.y() : -1;
    w.s_from = exact_end(w.s_from, surface, tolerance);
    w.s_to = exact_end(w.s_to, surface, tolerance);
    if (w.s_from >= w.s_to) continue;
    if (!joined.empty() && joined.back().block == w.block && joined.back().edge == w.edge &&
        w.s_from <= joined.back().s_to + tolerance) {
      joined.back().s_to = std::max(joined.back().s_to, w.s_to);
    } else {
      joined.push_back(w);
    }
  }
  intervals.swap(joined);
}

}  // namespace

WetFaces wet_faces(const std::vector<std::vector<Point>>& outlines, Pool pool, double level_m,
                   double open_crack_width_m) {
  WetFaces result;
  const Extent e = extent_of(outlines);
  if (outlines.empty() || level_m <= e.bottom) return result;
  const double pad = 1;  // m; any strip of open water beside the model will do
  cl::Paths taken = impervious(outlines, open_crack_width_m);
  const double wall = 1e-3;
  const Point crest = crest_corner(outlines, pool, e.top, open_crack_width_m);
  const double wall_left = pool == Pool::upstream ? crest.x() : crest.x() - wall;
  taken.push_back(rectangle(wall_left, crest.y() - wall, wall_left + wall, std::max(level_m, e.top) + pad));
  cl::Paths water;
  cl::Clipper clipper;
  clipper.AddPath(rectangle(e.left - pad, e.bottom, e.right + pad, level_m), cl::ptSubject, true);
  clipper.AddPaths(taken, cl::ptClip, true);
  clipper.Execute(cl::ctDifference, water, cl::pftNonZero, cl::pftNonZero);

  const double far_left = e.left - pad + tiny_m;
  const double far_right = e.right + pad - tiny_m;
  const auto add_boundary = [&](const cl::Path& path) {
    Ring& ring = result.region.emplace_back();
    for (const cl::IntPoint& p : path) ring.push_back(to_metres(p));
    for (std::size_t i = 0; i < path.size(); ++i) {
      map_to_edges(outlines, to_metres(path[i]), to_metres(path[(i + 1) % path.size()]), open_crack_width_m / 5,
                   result.intervals);
    }
  };
  for (const cl::Path& component : water) {
    if (!cl::Orientation(component)) continue;  // a hole: the outline of a block under water, see below
    bool left = false;
    bool right = false;
    for (const cl::IntPoint& corner : component) {
      left = left || to_metres(corner).x() < far_left;
      right = right || to_metres(corner).x() > far_right;
    }
    if (!(pool == Pool::upstream ? left : right)) continue;
    result.breached = result.breached || (left && right);
    add_boundary(component);
    for (const cl::Path& hole : water) {
      if (!cl::Orientation(hole) && cl::PointInPolygon(hole.front(), component) != 0) add_boundary(hole);
    }
  }
  tidy(outlines, level_m, open_crack_width_m, result.intervals);
  return result;
}

}  // namespace blockweir::hydrostatic
