// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/reordered.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::scene {

Scene reordered(Scene scene, const std::vector<int>& order) {
  std::vector<Block> blocks;
  std::vector<int> place(order.size());
  for (const int block : order) {
    place[at(block)] = static_cast<int>(blocks.size());
    blocks.push_back(std::move(scene.blocks[at(block)]));
  }
  scene.blocks = std::move(blocks);
  const auto follow = [&](int& block) {
    if (block >= 0) block = place[at(block)];  // below: the ground, or none
  };
  const auto follow_each = [&](auto& entries) {
    for (auto& entry : entries) follow(entry.block);
  };
  for (Joint& joint : scene.joints) std::for_each(joint.between.begin(), joint.between.end(), follow);
  for (Bolt& bolt : scene.bolts) std::for_each(bolt.blocks.begin(), bolt.blocks.end(), follow);
  for (BodyLoad& load : scene.body_loads) std::for_each(load.blocks.begin(), load.blocks.end(), follow);
  follow_each(scene.supports);
  follow_each(scene.viscous_faces);
  follow_each(scene.point_loads);
  follow_each(scene.face_pressures);
  follow_each(scene.line_loads);
  follow(scene.column.block);
  return scene;
}

std::vector<int> from_left_to_right(const Scene& scene, bool upwards) {
  std::vector<std::pair<double, double>> places;
  for (const Block& block : scene.blocks) {
    const geometry::Bounds box = geometry::bounds_of(block.vertices);
    const Eigen::Vector2d middle = (box.low + box.high) / 2;
    places.emplace_back(middle.x(), upwards ? middle.y() : -middle.y());
  }
  std::vector<int> order(scene.blocks.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return places[at(a)] < places[at(b)]; });
  return order;
}

}  // namespace blockweir::scene
