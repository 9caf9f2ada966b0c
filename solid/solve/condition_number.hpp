// SPDX-License-Identifier: GPL-3.0-or-later
// The condition number of a matrix.
#pragma once

#include <Eigen/Core>

namespace blockweir::solid {

/// In the 2-norm, of the matrix with rows and columns scaled to a largest entry of 1 (Ruiz 2001), so that units of
/// displacements, rotations, strains and forces do not matter. By singular values: for small systems.
double condition_number(Eigen::MatrixXd k);

}  // namespace blockweir::solid
