// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/dominant_eigenvalue.hpp"

#include <Eigen/Eigenvalues>

namespace blockweir::solid {

std::complex<double> dominant_eigenvalue(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXcd all = Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
  Eigen::Index largest = 0;
  all.cwiseAbs().maxCoeff(&largest);
  return all[largest];
}

}  // namespace blockweir::solid
