// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/corner_stands.hpp"

#include <algorithm>
#include <optional>

#include "bridge/scene/at.hpp"
#include "bridge/scene/block_index.hpp"
#include "bridge/scene/loose_blocks.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

/// Or by a bolt to another block.
std::vector<bool> held_otherwise(const Scene& scene) {
  std::vector<bool> held = held_by_themselves(scene);
  for (const Bolt& bolt : scene.bolts) {
    for (const int block : bolt.blocks) {
      if (block >= 0) held[at(block)] = true;
    }
  }
  return held;
}

/// The points where a block touches others, or nearly does, as far as they show that there is more than one place.
class Touched {
 public:
  Touched(double touching_m, double near_m) : touching_m_(touching_m), near_m_(near_m) {}

  /// Blocks that do not overlap touch where a corner of one lies on an edge of the other.
  void add(const Block& a, const Block& b) {
    add_corners(a.vertices, b.vertices);
    add_corners(b.vertices, a.vertices);
  }
  [[nodiscard]] bool at_several() const { return several_; }
  [[nodiscard]] std::optional<Point> corner() const { return several_ ? std::nullopt : corner_; }

 private:
  void add_corners(const std::vector<Point>& corners, const std::vector<Point>& edges) {
    for (const Point& corner : corners) {
      for (std::size_t i = 0; i < edges.size() && !several_; ++i) {
        const Point& to = edges[(i + 1) % edges.size()];
        const double away_m = geometry::distance_to_segment(corner, edges[i], to);
        if (away_m > near_m_) continue;
        if (!near_) near_ = corner;
        if (away_m <= touching_m_) corner_ = corner;
        several_ = (corner - *near_).norm() > 2 * near_m_;
      }
    }
  }

  double touching_m_;
  double near_m_;
  std::optional<Point> near_;
  std::optional<Point> corner_;
  bool several_ = false;
};

}  // namespace

std::vector<CornerStand> corner_stands(const Scene& scene) {
  constexpr double touching_ratio = 1e-6;  // of the structure
  constexpr double near_ratio = 0.01;      // of the block: coordinates are rounded, and faces dip a little
  const double touching_m = touching_ratio * structure_size_m(scene.blocks);
  const std::vector<bool> held = held_otherwise(scene);
  const BlockIndex index(scene.blocks);
  std::vector<CornerStand> found;
  for (std::size_t a = 0; a < scene.blocks.size(); ++a) {
    if (held[a]) continue;
    const geometry::Bounds box = geometry::bounds_of(scene.blocks[a].vertices);
    const double near_m = std::max(touching_m, near_ratio * box.size());
    const Point margin = Point::Constant(near_m);
    Touched touched(touching_m, near_m);
    for (const std::size_t b : index.meeting({box.low - margin, box.high + margin})) {
      if (b != a && !touched.at_several()) touched.add(scene.blocks[a], scene.blocks[b]);
    }
    if (const auto corner = touched.corner()) found.push_back({static_cast<int>(a), *corner});
  }
  return found;
}

}  // namespace blockweir::scene
