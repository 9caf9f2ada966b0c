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

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

class SparseSystem final : public LinearSystem {
 public:
  SparseSystem(const Unknowns& unknowns, const std::vector<std::pair<int, int>>& couples)
      : u_(unknowns), rows_(u_.count.size()), slots_(u_.count.size()) {
    const auto blocks = static_cast<int>(u_.count.size());
    for (int b = 0; b < blocks; ++b) rows_[at(b)].push_back(b);
    for (const auto& [a, b] : couples) {
      rows_[at(a)].push_back(b);
      rows_[at(b)].push_back(a);
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < blocks; ++column) {
      auto& rows = rows_[at(column)];
      std::sort(rows.begin(), rows.end());
      int slot = 0;
      for (const int row : rows) {
        slots_[at(column)].push_back(slot);
        slot += u_.count[at(row)];
        for (int j = 0; j < u_.count[at(column)]; ++j) {
          for (int i = 0; i < u_.count[at(row)]; ++i) {
            entries.emplace_back(u_.first[at(row)] + i, u_.first[at(column)] + j, 0.0);
          }
        }
      }
    }
    k_.resize(u_.total, u_.total);
    k_.setFromTriplets(entries.begin(), entries.end());
    k_.makeCompressed();
  }

  void set_zero() override { std::fill_n(k_.valuePtr(), k_.nonZeros(), 0.0); }

  void add(int row, int column, const Matrix6& k) override {
    const auto& rows = rows_[at(column)];
    const auto place = std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
    const int slot = slots_[at(column)][static_cast<std::size_t>(place)];
    const int count = u_.count[at(row)];
    for (int j = 0; j < u_.count[at(column)]; ++j) {
      double* column_start = k_.valuePtr() + k_.outerIndexPtr()[u_.first[at(column)] + j];
      Eigen::Map<Eigen::VectorXd>(column_start + slot, count) += k.col(j).head(count);
    }
  }

  bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) override {
    return symmetric ? solve_with(cholesky_, cholesky_ready_, f, d) : solve_with(lu_, lu_ready_, f, d);
  }

  [[nodiscard]] Eigen::MatrixXd dense() const override { return k_; }

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

  Unknowns u_;
  std::vector<std::vector<int>> rows_;   ///< block rows of each block column
  std::vector<std::vector<int>> slots_;  ///< where they begin within a column
  Sparse k_;
  Eigen::CholmodDecomposition<Sparse> cholesky_;
  Eigen::UmfPackLU<Sparse> lu_;
  bool cholesky_ready_ = false;
  bool lu_ready_ = false;
};

}  // namespace

std::unique_ptr<LinearSystem> make_sparse_system(const Unknowns& unknowns,
                                                 const std::vector<std::pair<int, int>>& couples) {
  return std::make_unique<SparseSystem>(unknowns, couples);
}

}  // namespace blockweir::solid
