// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/upstream_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/block_index.hpp"

namespace blockweir::scene {
namespace {

/// Smallest x of an outline at this height; infinite where it is not that high.
double leftmost(const std::vector<Point>& outline, double y) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    if ((a.y() > y) == (b.y() > y)) continue;
    least = std::min(least, a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  return least;
}

/// use(block, start, end) for each edge of what can move, counter-clockwise.
template <class Use>
void for_edges_that_move(const Scene& scene, Use use) {
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    if (scene.blocks[b].fixed) continue;
    const auto& outline = scene.blocks[b].vertices;
    for (std::size_t e = 0; e < outline.size(); ++e) use(b, outline[e], outline[(e + 1) % outline.size()]);
  }
}

}  // namespace

std::vector<UpstreamFace> upstream_faces(const Scene& scene, double below_m) {
  const BlockIndex index(scene.blocks);
  double left_end = std::numeric_limits<double>::infinity();
  for (const Block& block : scene.blocks) left_end = std::min(left_end, geometry::bounds_of(block.vertices).low.x());
  std::vector<UpstreamFace> faces;
  // Counter-clockwise: an edge that leads down looks upstream.
  for_edges_that_move(scene, [&](std::size_t b, const Point& top, const Point& bottom) {
    const double high = std::min(top.y(), below_m);
    if (bottom.y() >= high) return;
    const auto place = [&](double y) -> Point { return top + (y - top.y()) / (bottom.y() - top.y()) * (bottom - top); };
    const std::vector<std::size_t> beside =
        index.meeting({{left_end, bottom.y()}, {std::max(top.x(), bottom.x()), high}});
    std::vector<double> heights = {bottom.y(), high};
    for (const std::size_t other : beside) {
      for (const Point& p : scene.blocks[other].vertices) {
        if (p.y() > bottom.y() && p.y() < high) heights.push_back(p.y());
      }
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i) {
      const double middle = (heights[i - 1] + heights[i]) / 2;
      const double near = 1e-6 * (top - bottom).norm();
      const bool hidden = std::any_of(beside.begin(), beside.end(), [&](std::size_t other) {
        return leftmost(scene.blocks[other].vertices, middle) < place(middle).x() - near;
      });
      if (!hidden && heights[i] - heights[i - 1] > near) {
        faces.push_back({static_cast<int>(b), place(heights[i]), place(heights[i - 1])});
      }
    }
  });
  return faces;
}

std::vector<UpstreamFloor> upstream_floors(const Scene& scene, double below_m) {
  std::vector<UpstreamFloor> floors;
  // Counter-clockwise: what looks up leads to the left.
  for_edges_that_move(scene, [&](std::size_t b, const Point& right, const Point& left) {
    const double near = 1e-6 * (left - right).norm();
    if (left.x() >= right.x() || std::abs(left.y() - right.y()) > near || right.y() >= below_m) return;
    double end = right.x();
    for (const Block& other : scene.blocks) end = std::min(end, leftmost(other.vertices, right.y() + near));
    if (end - left.x() > near) floors.push_back({static_cast<int>(b), left, {end, right.y()}});
  });
  return floors;
}

}  // namespace blockweir::scene
