// SPDX-License-Identifier: GPL-3.0-or-later
// The dominant eigenvalue of a matrix: growth and rotation of a state that is multiplied by it repeatedly.
#pragma once

#include <Eigen/Core>
#include <complex>

namespace blockweir::solid {

/// The eigenvalue of largest modulus of a square matrix.
std::complex<double> dominant_eigenvalue(const Eigen::MatrixXd& matrix);

}  // namespace blockweir::solid
