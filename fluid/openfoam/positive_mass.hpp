// SPDX-License-Identifier: GPL-3.0-or-later
// Added mass of one block without what a linear solver's error takes below zero.
#pragma once

#include <Eigen/Eigenvalues>
#include <array>

namespace blockweir::openfoam {

/// The nearest matrix whose modes all resist motion, to a symmetric 3 x 3 matrix (xx, xy, xr, yy, yr, rr; kg, kg m,
/// kg m2 per metre) of a block that reaches reach_m from its centroid: a turn counts as the way that it goes there, so
/// that what is taken away is no larger than the error.
inline std::array<double, 6> positive_mass(const std::array<double, 6>& row, double reach_m) {
  const auto& [xx, xy, xr, yy, yr, rr] = row;
  const Eigen::Vector3d way(1, 1, reach_m);
  const Eigen::Vector3d per_way = way.cwiseInverse();
  Eigen::Matrix3d mass;
  mass << xx, xy, xr, xy, yy, yr, xr, yr, rr;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(per_way.asDiagonal() * mass * per_way.asDiagonal());
  if (modes.eigenvalues()[0] >= 0) return row;
  const Eigen::Matrix3d V = way.asDiagonal() * modes.eigenvectors();
  mass = V * modes.eigenvalues().cwiseMax(0).asDiagonal() * V.transpose();
  return {mass(0, 0), mass(0, 1), mass(0, 2), mass(1, 1), mass(1, 2), mass(2, 2)};
}

}  // namespace blockweir::openfoam
