// SPDX-License-Identifier: GPL-3.0-or-later
// Cholesky factors of a sparse symmetric positive definite matrix, front by front (fronts.hpp), and what many
// right-hand sides need that are zero but at few unknowns and wanted at few. Matrices of plane meshes have small
// fronts: libraries lose more time around each of them than in it (tests/bench/README.md).
#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "fluid/reservoir/front_kernels.hpp"
#include "fluid/reservoir/fronts.hpp"

namespace blockweir::reservoir {

class FrontalCholesky {
 public:
  /// For matrices that have their entries in the places of this one. Of symmetric matrices, the lower half.
  explicit FrontalCholesky(const Eigen::SparseMatrix<double>& lower) : fronts_(lower) {}

  /// False where the matrix is not positive definite.
  [[nodiscard]] bool factorize(const Eigen::SparseMatrix<double>& lower);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// G^T A^-1 G, of G = `right`.
  [[nodiscard]] Eigen::MatrixXd flexibility(const Eigen::SparseMatrix<double>& right) const;
  /// A^-1 `right`, at the unknowns `wanted` alone. `take` gets the number of the first column and some columns, one row
  /// for each of `wanted`.
  using Take = std::function<void(Eigen::Index first, const Eigen::MatrixXd& x)>;
  void solve(const Eigen::SparseMatrix<double>& right, const std::vector<int>& wanted, const Take& take) const;

 private:
  using Sides = Eigen::Matrix<double, Eigen::Dynamic, side_width, Eigen::RowMajor>;
  using Numbers = std::vector<std::size_t>;

  template <class Value>
  [[nodiscard]] Panel<Value> panel(std::size_t front, Value* factor) const;
  [[nodiscard]] Eigen::Index row_of(Eigen::Index unknown) const {
    return fronts_.row_of[static_cast<std::size_t>(unknown)];
  }
  [[nodiscard]] Numbers fronts_above(const Numbers& rows) const;
  Numbers forward_from(const Eigen::SparseMatrix<double>& right, Eigen::Index first, Sides& x) const;
  void clear(const Numbers& fronts, Sides& x) const;

  Fronts fronts_;
  std::vector<double> factor_;
  std::vector<double> work_;
};

}  // namespace blockweir::reservoir
