// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/at.hpp"
#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/ground_ends.hpp"
#include "bridge/scene/joint_flow.hpp"
#include "fluid/joints/joint_network.hpp"

namespace blockweir::joints {

GroundCut ground_cut(const scene::Scene& scene) {
  if (!scene::flows_in_joints(scene) || scene.blocks.empty()) return {};
  const scene::GroundEnds ends = scene::find_ground_ends(scene);
  const auto corner = [&](const std::optional<scene::BedCorner>& end) {
    return end ? std::optional(scene.blocks[at(end->block)].vertices[at(end->vertex)]) : std::nullopt;
  };
  return {corner(ends.left), corner(ends.right), scene::bounds_of(scene).low.y()};
}

}  // namespace blockweir::joints
