// SPDX-License-Identifier: GPL-3.0-or-later
// Forces on rigid blocks and their motions, per metre of thickness.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::solid::limit {

using geometry::Point;

/// Force x, force y [N/m] and moment about the block's centroid [N].
using Wrench = Eigen::Vector3d;
/// One a block of the scene; what acts on fixed ones does not matter.
using Wrenches = std::vector<Wrench>;

/// Velocity x, velocity y of the block's centroid, and its spin [1/m of the same].
using Twist = Eigen::Vector3d;
/// One a block of the scene, zero for fixed ones.
using Twists = std::vector<Twist>;

inline Wrench wrench_of(const Point& force, const Point& at, const Point& centroid) {
  return {force.x(), force.y(), geometry::cross(at - centroid, force)};
}

inline Point velocity_at(const Twist& twist, const Point& at, const Point& centroid) {
  const Point arm = at - centroid;
  return {twist.x() - twist.z() * arm.y(), twist.y() + twist.z() * arm.x()};
}

/// Power of the wrenches on the motion.
inline double power(const Wrenches& wrenches, const Twists& twists) {
  double sum = 0;
  for (std::size_t b = 0; b < twists.size(); ++b) sum += wrenches[b].dot(twists[b]);
  return sum;
}

/// first + factor * second
inline Wrenches combined(Wrenches first, double factor, const Wrenches& second) {
  for (std::size_t b = 0; b < first.size(); ++b) first[b] += factor * second[b];
  return first;
}

}  // namespace blockweir::solid::limit
