// SPDX-License-Identifier: GPL-3.0-or-later
// K d = f of one island in 6x6 blocks (5)-(6): contact terms between blocks off the diagonal, all else on it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "solid/block/block.hpp"

namespace blockweir::solid {

class LinearSystem {
 public:
  virtual ~LinearSystem() = default;

  virtual void set_zero() = 0;
  /// Adds to the 6x6 block at local (row, column); off the diagonal only where a couple was announced.
  virtual void add(int row, int column, const Matrix6& k) = 0;
  /// Factorizes what was added and solves; `symmetric` promises K = K^T, which lets a sparse system use Cholesky.
  /// False when the matrix is singular to working accuracy.
  virtual bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) = 0;
};

/// Dense for small islands, sparse above: see tests/bench/linear_system_bench for where they cross.
std::unique_ptr<LinearSystem> make_linear_system(int blocks, const std::vector<std::pair<int, int>>& couples);

std::unique_ptr<LinearSystem> make_dense_system(int blocks);
std::unique_ptr<LinearSystem> make_sparse_system(int blocks, const std::vector<std::pair<int, int>>& couples);

}  // namespace blockweir::solid
