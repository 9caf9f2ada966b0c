// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/touching_pairs.hpp"

#include "bridge/scene/block_index.hpp"
#include "bridge/scene/joint_trace.hpp"

namespace blockweir::scene {

std::set<std::pair<int, int>> touching_pairs(const Scene& scene, double touching_m) {
  const Point margin = Point::Constant(touching_m);
  const BlockIndex index(scene.blocks);
  std::set<std::pair<int, int>> pairs;
  for (std::size_t a = 0; a < scene.blocks.size(); ++a) {
    const geometry::Bounds box = geometry::bounds_of(scene.blocks[a].vertices);
    for (const std::size_t b : index.meeting({box.low - margin, box.high + margin})) {
      if (b <= a || (scene.blocks[a].fixed && scene.blocks[b].fixed)) continue;
      if (trace_joint(scene.blocks[a], scene.blocks[b], touching_m).pieces.empty()) continue;
      pairs.emplace(static_cast<int>(a), static_cast<int>(b));
    }
  }
  return pairs;
}

}  // namespace blockweir::scene
