// SPDX-License-Identifier: GPL-3.0-or-later
// Water that a block must push, as inertia of its rigid motion.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solid/block/block.hpp"

namespace blockweir::solid {

/// Symmetric, of (u0, v0, r0) about the centroid where it is now [kg/m, kg, kg m]. One a block of the scene, or none.
using AddedMasses = std::vector<Eigen::Matrix3d>;

/// Largest and smallest eigenvalue of M^-1 M_a over the block's rigid modes, M its own mass.
struct MassRatio {
  double largest = 0;
  double smallest = 0;
};

MassRatio mass_ratio(const Block& block, const Eigen::Matrix3d& added);

}  // namespace blockweir::solid
