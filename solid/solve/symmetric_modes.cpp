// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/symmetric_modes.hpp"

#include <Eigen/Eigenvalues>

namespace blockweir::solid {

SymmetricModes symmetric_modes(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(A);
  return {found.eigenvalues(), found.eigenvectors()};
}

SymmetricModes symmetric_modes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> found(A, B);
  return {found.eigenvalues(), found.eigenvectors()};
}

}  // namespace blockweir::solid
