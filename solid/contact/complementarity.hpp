// SPDX-License-Identifier: GPL-3.0-or-later
// Linear complementarity: w = M z + q, w >= 0, z >= 0, w . z = 0.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace blockweir::solid {

/// z by Lemke's complementary pivoting (Cottle, Pang and Stone 1992, The linear complementarity problem, 4.4) of n
/// equations (M n x n, q n), scaled so that all of M, and all of q, are of like size. None where it ends on a ray, or
/// after 20 n pivots.
std::optional<Eigen::VectorXd> solve_complementarity(const Eigen::MatrixXd& M, const Eigen::VectorXd& q);

}  // namespace blockweir::solid
