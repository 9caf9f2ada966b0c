// SPDX-License-Identifier: GPL-3.0-or-later
// Added mass of one block without what a linear solver's error takes below zero.
#pragma once

#include <Eigen/Eigenvalues>
#include <array>

namespace blockweir::openfoam {

/// Of a symmetric 3 x 3 matrix (xx, xy, xr, yy, yr, rr; kg, kg m, kg m2 per metre) the part whose modes resist motion.
/// Lengths and turns are compared as shares of what the matrix has on its diagonal.
inline std::array<double, 6> positive_mass(const std::array<double, 6>& row) {
  const auto& [xx, xy, xr, yy, yr, rr] = row;
  Eigen::Matrix3d mass;
  mass << xx, xy, xr, xy, yy, yr, xr, yr, rr;
  const Eigen::Vector3d scale = mass.diagonal().cwiseMax(0).cwiseSqrt();
  const Eigen::Vector3d inverse = scale.unaryExpr([](double s) { return s > 0 ? 1 / s : 0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(inverse.asDiagonal() * mass * inverse.asDiagonal());
  if (modes.eigenvalues()[0] >= 0 && scale.minCoeff() > 0) return row;
  const Eigen::Matrix3d V = scale.asDiagonal() * modes.eigenvectors();
  mass = V * modes.eigenvalues().cwiseMax(0).asDiagonal() * V.transpose();
  return {mass(0, 0), mass(0, 1), mass(0, 2), mass(1, 1), mass(1, 2), mass(2, 2)};
}

}  // namespace blockweir::openfoam
