// SPDX-License-Identifier: GPL-3.0-or-later
// Natural frequencies and shapes of M q'' + K q = 0.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace blockweir::solid {

struct NaturalMode {
  double omega_rad_per_s = 0;  ///< 0: nothing holds this motion
  Eigen::VectorXd shape;       ///< with shape . M shape = 1
};

/// The `count` lowest, or fewer, without those of the springs that stand for contacts: K shape = omega^2 M shape, M
/// positive definite, K symmetric and not negative (Lanczos with shift and inversion, Spectra). `typical_omega`: of the
/// structure, to tell free motions and those of contacts by. Throws std::runtime_error where they are not found.
std::vector<NaturalMode> natural_modes(const Eigen::SparseMatrix<double>& K, const Eigen::SparseMatrix<double>& M,
                                       int count, double typical_omega);

}  // namespace blockweir::solid
