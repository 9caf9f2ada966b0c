// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/added_mass_guard.hpp"

namespace blockweir::solid {

void AddedMassGuard::begin_window(const AddedMasses& masses, const std::vector<Eigen::Vector3d>& velocities,
                                  double time_s) {
  masses_ = masses;
  const std::size_t n = masses.own.size();
  const bool first = velocities_.size() != n;  // the water has seen no acceleration yet
  if (first) accelerations_.fill(std::vector<Eigen::Vector3d>(n, Eigen::Vector3d::Zero()));
  if (!first && time_s > time_s_) {
    accelerations_[2].swap(accelerations_[1]);
    accelerations_[1].swap(accelerations_[0]);
    for (std::size_t b = 0; b < n; ++b) {
      accelerations_[0][b] = (velocities[b] - velocities_[b]) / (time_s - time_s_);
    }
  }
  velocities_.assign(velocities.begin(), velocities.begin() + static_cast<std::ptrdiff_t>(n));
  time_s_ = time_s;
  begin_step({1, 0, 0});
}

void AddedMassGuard::begin_step(const WaterCourse::Weights& weights) {
  std::vector<Eigen::Vector3d> accelerations(motions(), Eigen::Vector3d::Zero());
  for (std::size_t b = 0; b < motions(); ++b) {
    for (std::size_t i = 0; i < weights.size(); ++i) accelerations[b] += weights[i] * accelerations_[i][b];
  }
  forces_ = masses_.times(accelerations);
}

}  // namespace blockweir::solid
