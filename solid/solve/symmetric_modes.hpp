// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues and eigenvectors of dense symmetric matrices. Only symmetric_modes.cpp includes Eigen's solver, which
// takes eight seconds to compile.
#pragma once

#include <Eigen/Core>

namespace blockweir::solid {

struct SymmetricModes {
  Eigen::VectorXd values;   ///< from the lowest up
  Eigen::MatrixXd vectors;  ///< a column each
};

/// A x = lambda x, x of unit length; A is symmetric, and its lower triangle alone is read.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& A);

/// A x = lambda B x, x'Bx = 1; B is symmetric and positive definite.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace blockweir::solid
