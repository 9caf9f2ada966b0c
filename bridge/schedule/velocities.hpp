// SPDX-License-Identifier: GPL-3.0-or-later
// Velocities in the solid's message, in groups of three that match the rows of the added mass.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bridge/wire/message.hpp"

namespace blockweir::schedule {

/// Rates of u0, v0, r0 of every block [m/s, rad/s]; then of the strains ex, ey, gxy of every block [1/s]; then x, y
/// (and 0) of every mesh corner on a face [m/s].
inline std::vector<Eigen::Vector3d> velocities_in(const wire::Motion& motion) {
  std::vector<Eigen::Vector3d> velocities;
  velocities.reserve(2 * motion.velocity.size() + motion.face_velocity.size());
  for (const auto& v : motion.velocity) velocities.emplace_back(v[0], v[1], v[2]);
  for (const auto& v : motion.velocity) velocities.emplace_back(v[3], v[4], v[5]);
  for (const auto& v : motion.face_velocity) velocities.emplace_back(v[0], v[1], 0);
  return velocities;
}

}  // namespace blockweir::schedule
