// SPDX-License-Identifier: GPL-3.0-or-later
// Large islands: block-sparse matrix with a pattern fixed by the contact graph.
#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/solve/sparse/keep_freed_memory.hpp"
#include "solid/solve/sparse/sparse_matrix.hpp"
#include "solid/solve/sparse/systems.hpp"

namespace blockweir::solid {
namespace {

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
    matrix_.set_pattern(u_.total, entries);
  }

  void set_zero() override { matrix_.set_zero(); }
  void set_beside(LowRank beside) override { matrix_.set_beside(std::move(beside)); }
  [[nodiscard]] bool reused() const override { return matrix_.reused(); }
  void keep_pivots_on_diagonal() override { matrix_.keep_pivots_on_diagonal(); }
  void forget_factors() override { matrix_.forget_factors(); }
  [[nodiscard]] KeptFactors kept_factors() const override { return matrix_.kept(); }
  void restore(const KeptFactors& kept) override { matrix_.restore(kept); }
  [[nodiscard]] SolutionTimes times() const override { return matrix_.times(); }

  void add(int row, int column, const Matrix6& k) override {
    const auto& rows = rows_[at(column)];
    const auto place = std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
    const int slot = slots_[at(column)][static_cast<std::size_t>(place)];
    const int count = u_.count[at(row)];
    for (int j = 0; j < u_.count[at(column)]; ++j) {
      double* column_start = matrix_.k.valuePtr() + matrix_.k.outerIndexPtr()[u_.first[at(column)] + j];
      for (int i = 0; i < count; ++i) column_start[slot + i] += k(i, j);
    }
  }

  bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) override {
    return matrix_.solve(symmetric, f, d);
  }

  [[nodiscard]] Eigen::VectorXd solve_again(const Eigen::VectorXd& f) override { return matrix_.solve_again(f); }

  [[nodiscard]] Eigen::MatrixXd dense() const override { return matrix_.dense(); }

 private:
  Unknowns u_;
  std::vector<std::vector<int>> rows_;   ///< block rows of each block column
  std::vector<std::vector<int>> slots_;  ///< where they begin within a column
  SparseMatrix matrix_;
};

}  // namespace

std::unique_ptr<LinearSystem> make_sparse_system(const Unknowns& unknowns,
                                                 const std::vector<std::pair<int, int>>& couples) {
  keep_freed_memory();
  return std::make_unique<SparseSystem>(unknowns, couples);
}

}  // namespace blockweir::solid
