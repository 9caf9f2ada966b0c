// SPDX-License-Identifier: GPL-3.0-or-later
// Islands with meshed blocks: a sparse matrix of nodes and blocks, with a pattern fixed by meshes and contacts.
#include <algorithm>

#include "solid/solve/sparse/sparse_matrix.hpp"
#include "solid/solve/sparse/systems.hpp"

namespace blockweir::solid {
namespace {

class NodalSystem final : public LinearSystem {
 public:
  NodalSystem(const Unknowns& unknowns, const std::vector<std::pair<int, int>>& couples) : u_(unknowns) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto couple = [&](int a, int b) {
      for (const int i : u_.of(a)) {
        for (const int j : u_.of(b)) entries.emplace_back(i, j, 0.0), entries.emplace_back(j, i, 0.0);
      }
    };
    for (int b = 0; b < u_.blocks(); ++b) couple(b, b);
    for (const auto& [a, b] : couples) couple(a, b);
    matrix_.set_pattern(u_.total, entries);
    columns_.resize(static_cast<std::size_t>(u_.blocks()));
    const auto find = [&](int row, int column) {
      auto& places = columns_[static_cast<std::size_t>(column)].emplace_back(Couple{row, {}}).places;
      for (const int j : u_.of(column)) {
        for (const int i : u_.of(row)) places.push_back(place(i, j));
      }
    };
    for (int b = 0; b < u_.blocks(); ++b) find(b, b);
    for (const auto& [a, b] : couples) find(a, b), find(b, a);
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
    const Matrix6 mapped = u_.mapped(row, column, k);
    const auto& couples = columns_[static_cast<std::size_t>(column)];
    const auto couple = std::find_if(couples.begin(), couples.end(), [=](const Couple& c) { return c.row == row; });
    const int* next = couple->places.data();
    const auto rows = static_cast<Eigen::Index>(u_.of(row).size());
    for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(u_.of(column).size()); ++j) {
      for (Eigen::Index i = 0; i < rows; ++i) matrix_.k.valuePtr()[*next++] += mapped(i, j);
    }
  }

  bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) override {
    return matrix_.solve(symmetric, f, d);
  }

  [[nodiscard]] Eigen::VectorXd solve_again(const Eigen::VectorXd& f) override { return matrix_.solve_again(f); }

  [[nodiscard]] Eigen::MatrixXd dense() const override { return matrix_.dense(); }

 private:
  /// Where the entries of a pair of blocks stand among the matrix's values, column by column.
  struct Couple {
    int row;
    std::vector<int> places;
  };

  [[nodiscard]] int place(int i, int j) {
    const int* rows = matrix_.k.innerIndexPtr();
    const int* const first = rows + matrix_.k.outerIndexPtr()[j];
    return static_cast<int>(std::lower_bound(first, rows + matrix_.k.outerIndexPtr()[j + 1], i) - rows);
  }

  const Unknowns& u_;
  std::vector<std::vector<Couple>> columns_;
  SparseMatrix matrix_;
};

}  // namespace

std::unique_ptr<LinearSystem> make_nodal_system(const Unknowns& unknowns,
                                                const std::vector<std::pair<int, int>>& couples) {
  return std::make_unique<NodalSystem>(unknowns, couples);
}

}  // namespace blockweir::solid
