// SPDX-License-Identifier: GPL-3.0-or-later
// Large islands: block-sparse matrix with a pattern fixed by the contact graph, so that the symbolic
// factorization is done once; Cholesky (CHOLMOD) while K is symmetric, LU (UMFPACK) while contacts slip.
#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <algorithm>

#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

class SparseSystem final : public LinearSystem {
 public:
  SparseSystem(int blocks, const std::vector<std::pair<int, int>>& couples) : rows_(static_cast<std::size_t>(blocks)) {
    for (int b = 0; b < blocks; ++b) rows_[static_cast<std::size_t>(b)].push_back(b);
    for (const auto& [a, b] : couples) {
      rows_[static_cast<std::size_t>(a)].push_back(b);
      rows_[static_cast<std::size_t>(b)].push_back(a);
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < blocks; ++column) {
      auto& rows = rows_[static_cast<std::size_t>(column)];
      std::sort(rows.begin(), rows.end());
      for (const int row : rows) {
        for (int j = 0; j < 6; ++j) {
          for (int i = 0; i < 6; ++i) entries.emplace_back(6 * row + i, 6 * column + j, 0.0);
        }
      }
    }
    k_.resize(6 * blocks, 6 * blocks);
    k_.setFromTriplets(entries.begin(), entries.end());
    k_.makeCompressed();
  }

  void set_zero() override { std::fill_n(k_.valuePtr(), k_.nonZeros(), 0.0); }

  void add(int row, int column, const Matrix6& k) override {
    const auto& rows = rows_[static_cast<std::size_t>(column)];
    const auto slot = std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
    for (int j = 0; j < 6; ++j) {
      Eigen::Map<Vector6>(k_.valuePtr() + k_.outerIndexPtr()[6 * column + j] + 6 * slot) += k.col(j);
    }
  }

  bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) override {
    return symmetric ? solve_with(cholesky_, cholesky_ready_, f, d) : solve_with(lu_, lu_ready_, f, d);
  }

 private:
  template <class Solver>
  bool solve_with(Solver& solver, bool& ready, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    if (!ready) {
      solver.analyzePattern(k_);
      ready = true;
    }
    solver.factorize(k_);
    if (solver.info() != Eigen::Success) return false;
    d = solver.solve(f);
    return solver.info() == Eigen::Success && d.allFinite();
  }

  std::vector<std::vector<int>> rows_;  ///< block rows of each block column
  Sparse k_;
  Eigen::CholmodDecomposition<Sparse> cholesky_;
  Eigen::UmfPackLU<Sparse> lu_;
  bool cholesky_ready_ = false;
  bool lu_ready_ = false;
};

}  // namespace

std::unique_ptr<LinearSystem> make_sparse_system(int blocks, const std::vector<std::pair<int, int>>& couples) {
  return std::make_unique<SparseSystem>(blocks, couples);
}

}  // namespace blockweir::solid
