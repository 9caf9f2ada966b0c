// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/pictured_structure.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace blockweir::picture {
namespace {

using scene::Point;

/// The higher of the ground's two ends: the highest points at the model's left and at its right edge.
double ground_m(const scene::Scene& scene, const geometry::Bounds& all) {
  const double near_m = 1e-6 * all.size();
  double left = -std::numeric_limits<double>::infinity();
  double right = left;
  for (const scene::Block& block : scene.blocks) {
    for (const Point& p : block.vertices) {
      if (p.x() <= all.low.x() + near_m) left = std::max(left, p.y());
      if (p.x() >= all.high.x() - near_m) right = std::max(right, p.y());
    }
  }
  return std::max(left, right);
}

}  // namespace

geometry::Bounds pictured_structure(const scene::Scene& scene) {
  std::vector<Point> every;
  std::vector<Point> movable;
  for (const scene::Block& block : scene.blocks) {
    every.insert(every.end(), block.vertices.begin(), block.vertices.end());
    if (!block.fixed) movable.insert(movable.end(), block.vertices.begin(), block.vertices.end());
  }
  const geometry::Bounds all = geometry::bounds_of(every);
  const double above_m = ground_m(scene, all) + 1e-6 * all.size();
  std::vector<Point> risen;
  for (const scene::Block& block : scene.blocks) {
    const auto rises = [&](const Point& p) { return p.y() > above_m; };
    if (block.fixed || std::none_of(block.vertices.begin(), block.vertices.end(), rises)) continue;
    risen.insert(risen.end(), block.vertices.begin(), block.vertices.end());
  }
  return !risen.empty() ? geometry::bounds_of(risen) : !movable.empty() ? geometry::bounds_of(movable) : all;
}

}  // namespace blockweir::picture
