// SPDX-License-Identifier: GPL-3.0-or-later
// A symmetric low-rank matrix added to a sparse one.
#pragma once

#include <Eigen/SparseCore>

namespace blockweir::solid {

/// U S U^T, with U n x r and S r x r, symmetric.
struct LowRank {
  Eigen::SparseMatrix<double> U;
  Eigen::MatrixXd S;

  [[nodiscard]] bool none() const { return S.size() == 0; }
};

}  // namespace blockweir::solid
