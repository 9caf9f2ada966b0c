// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/water_work.hpp"

namespace blockweir::solid {

std::vector<Eigen::Vector3d> water_forces(const std::vector<Panel>& panels, const std::vector<Block>& blocks,
                                          const std::vector<Placement>& placements, std::size_t described,
                                          scene::NodalRule rule) {
  std::vector<Eigen::Vector3d> forces(described, Eigen::Vector3d::Zero());
  for (const Panel& panel : panels) {
    const auto b = static_cast<std::size_t>(panel.block);
    forces[b] += generalized_force(placements[b], panel_force(blocks[b], placements[b], panel, rule)).head<3>();
  }
  return forces;
}

void WaterWork::begin_step(std::vector<Eigen::Vector3d> forces, const AddedMassGuard& guard, const Blocks& blocks) {
  forces_ = std::move(forces);
  displacement_.clear();
  for (std::size_t b = 0; b < forces_.size(); ++b) {
    if (b < guard.blocks()) forces_[b] += guard.force(b);
    displacement_.emplace_back(blocks.states[b].displacement.head<3>());
  }
  blocks.motions.add_corners(guard.forces(), blocks.placements, forces_);
  velocity_ = blocks.motions.velocities(blocks.states, guard.motions());
}

void WaterWork::end_step(const AddedMassGuard& guard, const Blocks& blocks, double dt, bool by_shi) {
  const bool mean = !by_shi && before_.size() == forces_.size();
  std::vector<Eigen::Vector3d> taken = blocks.motions.velocities(blocks.states, guard.motions());
  for (std::size_t m = 0; m < taken.size(); ++m) taken[m] = (taken[m] - velocity_[m]) / dt;
  taken = guard.masses().times(taken);  // by the water that blocks push
  blocks.motions.add_corners(taken, blocks.placements, taken);
  for (std::size_t b = 0; b < forces_.size(); ++b) {
    const Eigen::Vector3d way = blocks.states[b].displacement.head<3>() - displacement_[b];
    Eigen::Vector3d force = mean ? Eigen::Vector3d((before_[b] + forces_[b]) / 2) : forces_[b];
    if (b < guard.blocks()) force -= taken[b];
    sum_ += force.dot(way);
  }
  before_.swap(forces_);
}

}  // namespace blockweir::solid
