// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that overlap: the common area of outlines whose boxes overlap.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <polyclipping/clipper.hpp>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/block_index.hpp"
#include "bridge/scene/read/check.hpp"

namespace blockweir::scene {
namespace {

namespace cl = ClipperLib;

/// Metres about an origin to Clipper's integers and back, as fine as they can be.
struct Grid {
  Point origin;
  double per_m = 1;

  [[nodiscard]] cl::Path path(const Block& block) const {
    cl::Path path;
    for (const Point& p : block.vertices) {
      const Point q = per_m * (p - origin);
      path.emplace_back(std::llround(q.x()), std::llround(q.y()));
    }
    return path;
  }
  [[nodiscard]] std::vector<Point> metres(const cl::Path& path) const {
    std::vector<Point> points;
    for (const cl::IntPoint& p : path)
      points.push_back(origin + Point(static_cast<double>(p.X), static_cast<double>(p.Y)) / per_m);
    return points;
  }
};

double perimeter(const std::vector<Point>& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) sum += (outline[(i + 1) % outline.size()] - outline[i]).norm();
  return sum;
}

/// Pieces that both blocks cover, without those shallower than `tolerance`.
std::vector<std::vector<Point>> common_area(const Block& a, const Block& b, const Grid& grid, double tolerance) {
  cl::Paths common;
  cl::Clipper clipper;
  clipper.AddPath(grid.path(a), cl::ptSubject, true);
  clipper.AddPath(grid.path(b), cl::ptClip, true);
  clipper.Execute(cl::ctIntersection, common, cl::pftNonZero, cl::pftNonZero);
  std::vector<std::vector<Point>> pieces;
  for (const cl::Path& path : common) {
    std::vector<Point> piece = grid.metres(path);
    // Twice the area over the perimeter is the depth of a slender piece.
    if (2 * geometry::signed_area(piece) > tolerance * perimeter(piece)) pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Whether the longest edge of `a` has all of `b` on its outside and all of `a` on its inside.
bool parted_by_longest_edge(const Block& a, const Block& b) {
  Point from = a.vertices.back();
  Point along = Point::Zero();
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const Point edge = a.vertices[(i + 1) % a.vertices.size()] - a.vertices[i];
    if (edge.squaredNorm() > along.squaredNorm()) from = a.vertices[i], along = edge;
  }
  const auto left = [&](const Point& p) { return along.x() * (p.y() - from.y()) - along.y() * (p.x() - from.x()); };
  return std::all_of(b.vertices.begin(), b.vertices.end(), [&](const Point& p) { return left(p) <= 0; }) &&
         std::all_of(a.vertices.begin(), a.vertices.end(), [&](const Point& p) { return left(p) >= 0; });
}

/// Area of a pair and a point in it; no area where the two overlap by less than rounding.
struct Overlap {
  double area_m2 = 0;
  Point near = Point::Zero();
};

Overlap overlap_of(const Block& a, const Block& b) {
  const geometry::Bounds box_a = geometry::bounds_of(a.vertices);
  const geometry::Bounds box_b = geometry::bounds_of(b.vertices);
  const double tolerance = rounding_ratio * std::min(box_a.size(), box_b.size());
  const Point depth = box_a.high.cwiseMin(box_b.high) - box_a.low.cwiseMax(box_b.low);
  if (depth.minCoeff() <= tolerance || parted_by_longest_edge(a, b) || parted_by_longest_edge(b, a)) return {};
  const double reach = std::max(box_a.size(), box_b.size()) + (box_b.low - box_a.low).cwiseAbs().maxCoeff();
  constexpr double finest = 1e17;  // well below the largest integer that Clipper multiplies soundly
  const auto pieces = common_area(a, b, {box_a.low, finest / reach}, tolerance);
  if (pieces.empty()) return {};
  Overlap found{0, geometry::centroid(pieces.front())};
  for (const auto& piece : pieces) found.area_m2 += geometry::signed_area(piece);
  return found;
}

/// Overlaps of the blocks that two lines of the file make.
struct OfTwoLines {
  std::string first;
  std::size_t pairs = 0;
};

}  // namespace

bool overlap(const Block& a, const Block& b) {
  return overlap_of(a, b).area_m2 > 0;
}

void check_overlaps(const Scene& scene, Problems& problems) {
  const BlockIndex index(scene.blocks);
  std::map<std::pair<int, int>, OfTwoLines> found;
  std::size_t pairs = 0;  // nobody would read more
  for (std::size_t i = 0; i < scene.blocks.size() && pairs < Problems::largest_count; ++i) {
    const Block& a = scene.blocks[i];
    if (a.vertices.empty()) continue;
    std::vector<std::size_t> near = index.meeting(geometry::bounds_of(a.vertices));
    std::sort(near.begin(), near.end());
    for (const std::size_t j : near) {
      if (j <= i || pairs == Problems::largest_count) continue;
      const Block& b = scene.blocks[j];
      const Overlap common = overlap_of(a, b);
      if (!(common.area_m2 > 0)) continue;
      ++pairs;
      OfTwoLines& all = found[std::minmax(a.line, b.line)];
      if (++all.pairs > 1) continue;
      all.first = fmt::format("blocks \"{}\" and \"{}\" overlap by {:.4g} m2 near ({:.4g}, {:.4g})", a.name, b.name,
                              common.area_m2, common.near.x(), common.near.y());
    }
  }
  for (const auto& [lines, all] : found) {
    const bool one = all.pairs == 1;
    const std::string others = one ? ""
                                   : fmt::format(", and {}{} more pair{} of the blocks of lines {} and {}",
                                                 pairs == Problems::largest_count ? "at least " : "", all.pairs - 1,
                                                 all.pairs > 2 ? "s" : "", lines.first, lines.second);
    problems.error(problems.at(lines.second), all.first + others, "blocks that at most touch",
                   one ? "move the vertices of one of them to the common boundary"
                       : "move one of the two, by its origin_m or its outline");
  }
}

}  // namespace blockweir::scene
