// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/condition_number.hpp"

#include <Eigen/SVD>

namespace blockweir::solid {

double condition_number(Eigen::MatrixXd k) {
  constexpr int sweeps = 10;  // each halves what the logarithms of rows and columns are off by
  for (int i = 0; i < sweeps; ++i) {
    const Eigen::VectorXd rows = k.cwiseAbs().rowwise().maxCoeff().cwiseSqrt().cwiseInverse();
    const Eigen::RowVectorXd columns = k.cwiseAbs().colwise().maxCoeff().cwiseSqrt().cwiseInverse();
    k = rows.asDiagonal() * k * columns.asDiagonal();
  }
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner>(k).singularValues();
  return singular[0] / singular[singular.size() - 1];
}

}  // namespace blockweir::solid
