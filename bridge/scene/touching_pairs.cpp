// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/touching_pairs.hpp"

#include "bridge/scene/block_index.hpp"

namespace blockweir::scene {

std::map<std::pair<int, int>, JointTrace> touching_joints(const Scene& scene, double touching_m) {
  const Point margin = Point::Constant(touching_m);
  const BlockIndex index(scene.blocks);
  std::map<std::pair<int, int>, JointTrace> joints;
  for (std::size_t a = 0; a < scene.blocks.size(); ++a) {
    const geometry::Bounds box = geometry::bounds_of(scene.blocks[a].vertices);
    for (const std::size_t b : index.meeting({box.low - margin, box.high + margin})) {
      if (b <= a || (scene.blocks[a].fixed && scene.blocks[b].fixed)) continue;
      JointTrace trace = trace_joint(scene.blocks[a], scene.blocks[b], touching_m);
      if (trace.pieces.empty()) continue;
      joints.emplace(std::pair(static_cast<int>(a), static_cast<int>(b)), std::move(trace));
    }
  }
  return joints;
}

std::set<std::pair<int, int>> touching_pairs(const Scene& scene, double touching_m) {
  std::set<std::pair<int, int>> pairs;
  for (const auto& [pair, trace] : touching_joints(scene, touching_m)) pairs.insert(pair);
  return pairs;
}

}  // namespace blockweir::scene
