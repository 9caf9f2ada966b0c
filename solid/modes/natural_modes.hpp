// SPDX-License-Identifier: GPL-3.0-or-later
// Natural frequencies and mode shapes of M q'' + K q = 0.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace blockweir::solid {

struct NaturalMode {
  double omega_rad_per_s = 0;  ///< 0: rigid-body motion
  Eigen::VectorXd shape;       ///< normalized: shape . M shape = 1
};

/// The `count` lowest modes, or fewer, without those of the contact springs: K shape = omega^2 M shape, M positive
/// definite, K symmetric and not negative (Lanczos with shift and inversion, Spectra). `typical_omega` of the structure
/// separates rigid-body motions and contact modes from the others. Throws std::runtime_error if they are not found.
std::vector<NaturalMode> natural_modes(const Eigen::SparseMatrix<double>& K, const Eigen::SparseMatrix<double>& M,
                                       int count, double typical_omega);

}  // namespace blockweir::solid
