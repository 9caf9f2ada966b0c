// SPDX-License-Identifier: GPL-3.0-or-later
// Islands with meshed blocks: a sparse matrix of nodes and blocks, with a pattern fixed by meshes and contacts.

#include "solid/solve/linear_system.hpp"
#include "solid/solve/sparse_matrix.hpp"

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
  }

  void set_zero() override { matrix_.set_zero(); }
  [[nodiscard]] bool reused() const override { return matrix_.reused(); }
  void forget_factors() override { matrix_.forget_factors(); }
  [[nodiscard]] KeptFactors kept_factors() const override { return matrix_.kept(); }
  void restore(const KeptFactors& kept) override { matrix_.restore(kept); }
  [[nodiscard]] SolutionTimes times() const override { return matrix_.times(); }

  void add(int row, int column, const Matrix6& k) override {
    const Matrix6 mapped = u_.mapped(row, column, k);
    for (std::size_t j = 0; j < u_.of(column).size(); ++j) {
      for (std::size_t i = 0; i < u_.of(row).size(); ++i) {
        matrix_.k.coeffRef(u_.of(row)[i], u_.of(column)[j]) +=
            mapped(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
    }
  }

  bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) override {
    return matrix_.solve(symmetric, f, d);
  }

  [[nodiscard]] Eigen::VectorXd solve_again(const Eigen::VectorXd& f) const override { return matrix_.solve_again(f); }

  [[nodiscard]] Eigen::MatrixXd dense() const override { return matrix_.k; }

 private:
  const Unknowns& u_;
  SparseMatrix matrix_;
};

}  // namespace

std::unique_ptr<LinearSystem> make_nodal_system(const Unknowns& unknowns,
                                                const std::vector<std::pair<int, int>>& couples) {
  return std::make_unique<NodalSystem>(unknowns, couples);
}

}  // namespace blockweir::solid
