// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of rigid blocks, and the power of forces on them, per metre of thickness.
#pragma once

#include "bridge/statics/wrench.hpp"

namespace blockweir::solid::limit {

using statics::combined;
using statics::Point;
using statics::Wrench;
using statics::wrench_of;
using statics::Wrenches;

/// Velocities in x and y of the block's centroid, and its angular velocity.
using Twist = Eigen::Vector3d;
/// One for each block of the scene, zero for fixed ones.
using Twists = std::vector<Twist>;

inline Point velocity_at(const Twist& twist, const Point& at, const Point& centroid) {
  const Point arm = at - centroid;
  return {twist.x() - twist.z() * arm.y(), twist.y() + twist.z() * arm.x()};
}

/// Power of the wrenches on this motion.
inline double power(const Wrenches& wrenches, const Twists& twists) {
  double sum = 0;
  for (std::size_t b = 0; b < twists.size(); ++b) sum += wrenches[b].dot(twists[b]);
  return sum;
}

}  // namespace blockweir::solid::limit
