// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/wet_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <polyclipping/clipper.hpp>

namespace blockweir::hydrostatic {
namespace {

namespace cl = ClipperLib;
constexpr double tiny_m = 1e-6;  // shorter than anything that matters, longer than round-off

/// Metres to Clipper's whole numbers and back: 1e-12 m each, coarser where the model is larger than Clipper then takes.
struct Grid {
  Point origin_m;  ///< multiples of 2^20 m: none where the model is less than 500 km from it
  double per_m;
  double unit_m;

  /// `size_m` in each direction from the middle.
  Grid(const Point& middle, double size_m) {
    constexpr double step_m = 1048576;
    for (const int i : {0, 1}) origin_m[i] = step_m * std::nearbyint(middle[i] / step_m);
    per_m = std::ldexp(1.0, std::min(40, 60 - std::ilogb(size_m + step_m / 2)));
    unit_m = 1 / per_m;
  }
  [[nodiscard]] cl::IntPoint units(const Point& p) const {
    const auto whole = [&](double metres) {
      return static_cast<cl::cInt>(metres * per_m + std::copysign(0.5, metres));
    };
    return {whole(p.x() - origin_m.x()), whole(p.y() - origin_m.y())};
  }
  [[nodiscard]] Point metres(const cl::IntPoint& p) const {
    return {origin_m.x() + static_cast<double>(p.X) * unit_m, origin_m.y() + static_cast<double>(p.Y) * unit_m};
  }
  [[nodiscard]] cl::Path units(const Ring& ring) const {
    cl::Path path;
    path.reserve(ring.size());
    for (const Point& p : ring) path.push_back(units(p));
    return path;
  }
};

/// Growing, Clipper and moving back have rounded: corners at round numbers are there again.
Point on_coarse_grid(const Point& p) {
  constexpr double per_m = 68719476736.0;  // 2^36, of any grid
  return {std::nearbyint(p.x() * per_m) / per_m, std::nearbyint(p.y() * per_m) / per_m};
}

Ring rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

using Extent = Eigen::AlignedBox2d;

Extent extent_of(const std::vector<Point>& outline) {
  Extent extent;
  for (const Point& p : outline) extent.extend(p);
  return extent;
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

/// What the grown blocks and wall leave of the frame: its outer rings and holes.
cl::Paths water_between(const std::vector<std::vector<Point>>& outlines, const Ring& wall, const Ring& frame,
                        double growth_m, const Grid& grid) {
  const Point most = Point::Constant(2 * growth_m);  // how far a corner grows, and more
  const Extent reach(frame[0] - most, frame[2] + most);
  cl::Clipper clipper;
  clipper.AddPath(grid.units(frame), cl::ptSubject, true);
  for (const auto& outline : outlines) {
    if (extent_of(outline).intersects(reach)) clipper.AddPath(grid.units(grown(outline, growth_m)), cl::ptClip, true);
  }
  clipper.AddPath(grid.units(grown(wall, growth_m)), cl::ptClip, true);
  cl::Paths water;
  clipper.Execute(cl::ctDifference, water, cl::pftPositive, cl::pftPositive);
  return water;
}

/// The water's boundary where the blocks are: the frame, which is as much larger as they are, moves towards the water.
std::vector<Piece> moved_back(const cl::Path& path, const Ring& frame, double growth_m, const Grid& grid) {
  const cl::IntPoint low = grid.units(frame[0]);
  const cl::IntPoint high = grid.units(frame[2]);
  Ring ring;
  std::vector<double> right_m;
  ring.reserve(path.size());
  right_m.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const cl::IntPoint& a = path[i];
    const cl::IntPoint& b = path[(i + 1) % path.size()];
    if ((grid.metres(b) - grid.metres(a)).norm() < tiny_m) continue;  // of no direction
    const bool upright = a.X == b.X && (a.X == low.X || a.X == high.X);
    const bool level = a.Y == b.Y && (a.Y == low.Y || a.Y == high.Y);
    ring.push_back(grid.metres(a));
    right_m.push_back(upright || level ? -growth_m : growth_m);
  }
  std::vector<Piece> pieces = moved_right(ring, right_m);
  for (Piece& piece : pieces) piece = {on_coarse_grid(piece.from), on_coarse_grid(piece.to)};
  return pieces;
}

/// What of an edge of a block is under the level.
struct SunkenEdge {
  int block;
  int edge;
  Point from;
  Point along;
  double length_m;
  double s_from;
  double s_to;
};

std::vector<SunkenEdge> sunken_edges(const std::vector<std::vector<Point>>& outlines, double level_m) {
  std::vector<SunkenEdge> edges;
  edges.reserve(4 * outlines.size());
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const auto& outline = outlines[k];
    for (std::size_t e = 0; e < outline.size(); ++e) {
      const Point& from = outline[e];
      const Point span = outline[(e + 1) % outline.size()] - from;
      const bool flat = std::abs(span.y()) < tiny_m;
      if (flat && from.y() >= level_m) continue;
      const double surface = flat ? 1 : std::clamp((level_m - from.y()) / span.y(), 0.0, 1.0);
      const double length = span.norm();
      const auto [low, high] = span.y() < 0 && !flat ? std::pair(surface, 1.0) : std::pair(0.0, surface);
      if (low >= high) continue;
      edges.push_back({static_cast<int>(k), static_cast<int>(e), from, span / length, length, low, high});
    }
  }
  return edges;
}

/// Adds the parts of edges that lie on the pool's boundary. Filling the gaps moves the boundary by less than `near_m`
/// where blocks have slipped a little past each other.
void map_to_edges(const std::vector<SunkenEdge>& edges, const Piece& boundary, double near_m,
                  std::vector<WetInterval>& intervals) {
  const auto& [a, b] = boundary;
  const double parallel = 0.99 * (b - a).norm();
  for (const SunkenEdge& edge : edges) {
    const Point& t = edge.along;
    if (std::abs(t.dot(b - a)) <= parallel) continue;
    const auto away = [&](const Point& q) {
      return std::abs(t.x() * (q - edge.from).y() - t.y() * (q - edge.from).x());
    };
    if (away(a) > near_m || away(b) > near_m) continue;
    const auto [s0, s1] = std::minmax({t.dot(a - edge.from) / edge.length_m, t.dot(b - edge.from) / edge.length_m});
    const double from = std::max(edge.s_from, s0);
    const double to = std::min(edge.s_to, s1);
    if ((to - from) * edge.length_m > tiny_m) intervals.push_back({edge.block, edge.edge, from, to});
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
  joined.reserve(intervals.size());
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

/// Of the pool in this frame; `breached` where it reaches from the frame's left to its right, `behind` where it passes
/// `middle_m`.
WetFaces wet_faces_within(const Ring& frame, const std::vector<std::vector<Point>>& outlines, const Ring& wall,
                          double middle_m, Pool pool, double level_m, double open_crack_width_m, const Grid& grid) {
  WetFaces result;
  const double growth = open_crack_width_m / 2;
  const cl::Paths water = water_between(outlines, wall, frame, growth, grid);
  const std::vector<SunkenEdge> edges = sunken_edges(outlines, level_m);
  result.intervals.reserve(edges.size());
  const double far_left = frame[0].x() + tiny_m;
  const double far_right = frame[2].x() - tiny_m;
  const auto add_boundary = [&](const cl::Path& path) {
    const std::vector<Piece> pieces = moved_back(path, frame, growth, grid);
    Ring& ring = result.region.emplace_back();
    ring.reserve(2 * pieces.size());
    for (const Piece& piece : pieces) {
      ring.insert(ring.end(), {piece.from, piece.to});
      map_to_edges(edges, piece, open_crack_width_m / 5, result.intervals);
    }
  };
  for (const cl::Path& component : water) {
    if (!cl::Orientation(component)) continue;  // a hole: the outline of a block under water, see below
    double leftmost = far_right;
    double rightmost = far_left;
    for (const cl::IntPoint& corner : component) {
      leftmost = std::min(leftmost, grid.metres(corner).x());
      rightmost = std::max(rightmost, grid.metres(corner).x());
    }
    const bool left = leftmost < far_left;
    const bool right = rightmost > far_right;
    if (!(pool == Pool::upstream ? left : right)) continue;
    result.breached = result.breached || (left && right);
    result.behind =
        result.behind || (pool == Pool::upstream ? rightmost > middle_m - tiny_m : leftmost < middle_m + tiny_m);
    add_boundary(component);
    for (const cl::Path& hole : water) {
      if (!cl::Orientation(hole) && cl::PointInPolygon(hole.front(), component) != 0) add_boundary(hole);
    }
  }
  tidy(outlines, level_m, open_crack_width_m, result.intervals);
  return result;
}

}  // namespace

WetFaces wet_faces(const std::vector<std::vector<Point>>& outlines, Pool pool, double level_m,
                   double open_crack_width_m, bool expected_behind) {
  Extent all;
  for (const auto& outline : outlines) all.extend(extent_of(outline));
  if (outlines.empty() || level_m <= all.min().y()) return {};
  const double growth = open_crack_width_m / 2;
  const double pad = 1 + growth;  // m; any strip of open water beside the model will do
  const double wall = 1e-3;
  const Point crest = crest_corner(outlines, pool, all.max().y(), open_crack_width_m);
  const double wall_left = pool == Pool::upstream ? crest.x() : crest.x() - wall;
  const Ring thin_wall =
      rectangle(wall_left, crest.y() - wall, wall_left + wall, std::max(level_m, all.max().y()) + pad);
  const Extent reach(all.min(), Point(all.max().x(), std::max(level_m, all.max().y())));
  const Grid grid(reach.center(), reach.sizes().maxCoeff() / 2 + 2 * pad);
  const double middle = wall_left + wall / 2;
  const auto between = [&](double left, double right) {
    const Ring frame = rectangle(left, all.min().y() - growth, right, level_m + growth);
    return wet_faces_within(frame, outlines, thin_wall, middle, pool, level_m, open_crack_width_m, grid);
  };
  // What lies beyond the wall matters only where water gets there: to look at half the model takes less.
  const double left = all.min().x() - pad;
  const double right = all.max().x() + pad;
  if (expected_behind) {
    WetFaces found = between(left, right);
    if (found.behind) return found;
  }
  WetFaces found = pool == Pool::upstream ? between(left, middle) : between(middle, right);
  return found.behind ? between(left, right) : found;
}

}  // namespace blockweir::hydrostatic
