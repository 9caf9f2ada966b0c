// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/added_mass.hpp"

#include <Eigen/Eigenvalues>

namespace blockweir::solid {

MassRatio mass_ratio(const Block& block, const Eigen::Matrix3d& added) {
  // About the centroid the block's own rigid mass is diagonal.
  const Eigen::Vector3d scale = block.inertia.matrix().diagonal().head<3>().cwiseSqrt().cwiseInverse();
  const Eigen::Matrix3d scaled = scale.asDiagonal() * added * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(scaled, Eigen::EigenvaluesOnly);
  return {modes.eigenvalues().maxCoeff(), modes.eigenvalues().minCoeff()};
}

}  // namespace blockweir::solid
