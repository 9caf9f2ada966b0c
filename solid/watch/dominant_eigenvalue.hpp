// SPDX-License-Identifier: GPL-3.0-or-later
// How a state that is multiplied by a matrix again and again grows and turns.
#pragma once

#include <Eigen/Core>
#include <complex>

namespace blockweir::solid {

/// The eigenvalue of largest modulus of a square matrix.
std::complex<double> dominant_eigenvalue(const Eigen::MatrixXd& matrix);

}  // namespace blockweir::solid
