// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a solution's digits a matrix costs.
#pragma once

#include <Eigen/Core>

namespace blockweir::solid {

/// In the 2-norm, of the matrix with rows and columns scaled to a largest entry of 1 (Ruiz 2001): units of
/// displacements, turns, strains and forces have no part in it. By singular values: for small systems.
double condition_number(Eigen::MatrixXd k);

}  // namespace blockweir::solid
