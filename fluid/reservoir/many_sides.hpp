// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse Cholesky factors with many right-hand sides that are zero but at few unknowns, wanted at few.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

namespace blockweir::reservoir {

class ManySides {
 public:
  using Factors = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
  static constexpr Eigen::Index width = 8;  ///< right-hand sides at once
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor>;

  /// `factors` are to outlive it. `wanted`: the unknowns that right-hand sides have and solutions are wanted at.
  ManySides(const Factors& factors, const std::vector<int>& wanted);

  /// Right-hand sides, unknowns x width, in the factors' order: row `row_of(unknown)`. Solutions take their place, at
  /// the wanted unknowns alone.
  void solve(Rows& x) const;
  [[nodiscard]] Eigen::Index row_of(int unknown) const;

 private:
  const Factors& factors_;
  std::vector<Eigen::Index> rows_;  ///< that the wanted ones depend on, in order
};

}  // namespace blockweir::reservoir
