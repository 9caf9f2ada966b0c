// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/wet_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fluid/hydrostatic/pool_outline.hpp"

namespace blockweir::hydrostatic {
namespace {

constexpr double tiny_m = 1e-6;  // shorter than anything that matters, longer than round-off

/// Growing, crossing and moving back have rounded: corners at round numbers are there again.
Point on_coarse_grid(const Point& p) {
  constexpr double per_m = 1 / (16 * outline_unit_m);
  return {std::nearbyint(p.x() * per_m) / per_m, std::nearbyint(p.y() * per_m) / per_m};
}

Ring rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
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

/// What the grown blocks and a thin wall leave of the water, and how far everything has grown.
struct GrownSection {
  Ring frame;
  std::vector<OutlineRing> rings;
  std::vector<double> growth_m;  ///< of the blocks and the wall
  double frame_growth_m = 0;
};

bool reaches_below(const std::vector<Point>& outline, double height) {
  return std::any_of(outline.begin(), outline.end(), [&](const Point& p) { return p.y() < height; });
}

/// Each block grows by a whole number of units more than the one before it, so that faces in one line, or as far apart
/// as gaps close, do not touch but cross or keep apart; the frame grows less than all, so that there is no film of
/// water between it and a block. What is above the water is not in its way. Where edges touch nevertheless, other
/// numbers are tried.
GrownSection grown_section(const std::vector<std::vector<Point>>& outlines, const Ring& wall, const Extent& e,
                           double level_m, double growth_m, FrameSide side) {
  const std::size_t n = outlines.size();
  const double pad = 1 + growth_m;  // m; any strip of open water beside the model will do
  GrownSection section;
  std::vector<Ring> obstacles(n + 1);
  section.growth_m.resize(n + 1);
  for (int step = 4; step < 400; ++step) {  // units
    const auto more = [&](std::size_t k) { return static_cast<double>(k + 1) * step * outline_unit_m; };
    for (std::size_t k = 0; k <= n; ++k) {
      section.growth_m[k] = growth_m + more(k);
      const Ring& outline = k < n ? outlines[k] : wall;
      if (reaches_below(outline, level_m + 4 * growth_m)) obstacles[k] = grown(outline, section.growth_m[k]);
    }
    section.frame_growth_m = growth_m - more(n + 1);
    section.frame =
        rectangle(e.left - pad, e.bottom - section.frame_growth_m, e.right + pad, level_m + section.frame_growth_m);
    if (auto rings = pool_outline(section.frame, side, obstacles)) {
      section.rings = std::move(*rings);
      return section;
    }
  }
  throw std::logic_error("edges of grown blocks touch however much they grow");
}

/// The water's boundary where the blocks are: the frame, which is as much larger as they are, moves towards the water.
std::vector<Piece> moved_back(const OutlineRing& outline, const GrownSection& section) {
  Ring ring;
  std::vector<double> right_m;
  const std::size_t n = outline.corner.size();
  ring.reserve(n);
  right_m.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point& a = outline.corner[i];
    if ((outline.corner[(i + 1) % n] - a).squaredNorm() < tiny_m * tiny_m) continue;  // of no direction
    const int on = outline.on[i];
    ring.push_back(a);
    right_m.push_back(on == OutlineRing::frame ? -section.frame_growth_m
                                               : section.growth_m[static_cast<std::size_t>(on)]);
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
  const double farthest =
      std::max({std::abs(e.left), std::abs(e.right), std::abs(e.bottom), std::abs(e.top), std::abs(level_m)});
  if (!(farthest < largest_coordinate_m / 2)) {
    throw std::runtime_error(fmt::format(
        "a block or the level is {:.3g} m from the origin; still water is found up to {:.0f} m from it: end "
        "the run before blocks are that far, or move the section to the origin",
        farthest, largest_coordinate_m / 2));
  }
  constexpr double wall = 1e-3;
  const Point crest = crest_corner(outlines, pool, e.top, open_crack_width_m);
  const double wall_left = pool == Pool::upstream ? crest.x() : crest.x() - wall;
  const GrownSection section = grown_section(
      outlines,
      rectangle(wall_left, crest.y() - wall, wall_left + wall, std::max(level_m, e.top) + 1 + open_crack_width_m), e,
      level_m, open_crack_width_m / 2, pool == Pool::upstream ? FrameSide::left : FrameSide::right);

  const std::vector<SunkenEdge> edges = sunken_edges(outlines, level_m);
  for (const OutlineRing& outline : section.rings) {
    Ring& ring = result.region.emplace_back();
    ring.reserve(2 * outline.corner.size());
    for (const Piece& piece : moved_back(outline, section)) {
      ring.insert(ring.end(), {piece.from, piece.to});
      map_to_edges(edges, piece, open_crack_width_m / 5, result.intervals);
    }
  }
  const auto reaches = [&](const Point& of_frame) {
    const Ring& outer = section.rings.front().corner;
    return std::any_of(outer.begin(), outer.end(),
                       [&](const Point& p) { return std::abs(p.x() - of_frame.x()) < tiny_m; });
  };
  result.breached = reaches(section.frame[0]) && reaches(section.frame[1]);
  tidy(outlines, level_m, open_crack_width_m, result.intervals);
  return result;
}

}  // namespace blockweir::hydrostatic
