// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/added_mass_guard.hpp"

namespace blockweir::solid {

void AddedMassGuard::begin_window(const AddedMasses& masses, const std::vector<BlockState>& states, double window_s) {
  masses_ = masses;
  forces_.resize(masses.size());
  const bool first = velocities_.size() != masses.size();  // the water has seen no acceleration yet
  velocities_.resize(masses.size());
  for (std::size_t b = 0; b < masses.size(); ++b) {
    const Eigen::Vector3d velocity = states[b].velocity.head<3>();
    const Eigen::Vector3d change = first ? Eigen::Vector3d::Zero() : Eigen::Vector3d(velocity - velocities_[b]);
    forces_[b] = first ? change : Eigen::Vector3d(masses[b] * (change / window_s_));
    velocities_[b] = velocity;
  }
  window_s_ = window_s;
}

}  // namespace blockweir::solid
