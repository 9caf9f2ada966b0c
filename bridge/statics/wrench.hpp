// SPDX-License-Identifier: GPL-3.0-or-later
// Forces on rigid blocks, per metre of thickness.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::statics {

using geometry::Point;

/// Force x, force y [N/m] and moment about the block's centroid [N].
using Wrench = Eigen::Vector3d;
/// One for each block of the scene; those on fixed blocks are not used.
using Wrenches = std::vector<Wrench>;

inline Wrench wrench_of(const Point& force, const Point& at, const Point& centroid) {
  return {force.x(), force.y(), geometry::cross(at - centroid, force)};
}

/// first + factor * second
inline Wrenches combined(Wrenches first, double factor, const Wrenches& second) {
  for (std::size_t b = 0; b < first.size(); ++b) first[b] += factor * second[b];
  return first;
}

}  // namespace blockweir::statics
