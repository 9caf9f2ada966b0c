// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/water_motions.hpp"

#include "bridge/scene/at.hpp"
#include "bridge/scene/water_answers.hpp"

namespace blockweir::solid {

WaterMotions::WaterMotions(const scene::Scene& scene, const MovingParts& parts)
    : parts_(parts), blocks_(scene.blocks.size()) {
  if (!scene::answers_bending(scene)) return;
  for (std::size_t b = 0; b < blocks_; ++b) {
    if (scene.blocks[b].fixed || parts.triangles[b].empty()) continue;
    for (const OutlineSide& side : parts.outlines[b]) corners_.push_back({static_cast<int>(b), side});
  }
}

MotionShare WaterMotions::share(std::size_t motion) const {
  MotionShare share;
  if (motion < 2 * blocks_) {
    share.part = static_cast<int>(motion % blocks_);
    share.by_rates.block<3, 3>(0, motion < blocks_ ? 0 : 3).setIdentity();
  } else {
    const OutlineSide& side = corners_[motion - 2 * blocks_].side;
    share.part = side.part;
    share.by_rates.block<2, 2>(0, 2 * static_cast<Eigen::Index>(side.edge)).setIdentity();
  }
  return share;
}

std::vector<Eigen::Vector3d> WaterMotions::velocities(const std::vector<BlockState>& states, std::size_t count) const {
  std::vector<Eigen::Vector3d> velocities;
  for (std::size_t m = 0; m < count; ++m) {
    const MotionShare of = share(m);
    velocities.emplace_back(of.by_rates * states[at(of.part)].velocity);
    if (parts_.blocks[at(of.part)].fixed) velocities.back().setZero();
  }
  return velocities;
}

void WaterMotions::add_corners(const std::vector<Eigen::Vector3d>& of_motions, const std::vector<Placement>& placements,
                               std::vector<Eigen::Vector3d>& of_blocks) const {
  for (std::size_t m = 2 * blocks_; m < of_motions.size(); ++m) {
    const auto& [block, side] = corners_[m - 2 * blocks_];
    const Point arm = placements[at(side.part)].position(parts_.vertex(side)) - placements[at(block)].centre();
    const Point force = of_motions[m].head<2>();
    of_blocks[at(block)] += Eigen::Vector3d(force.x(), force.y(), arm.x() * force.y() - arm.y() * force.x());
  }
}

}  // namespace blockweir::solid
