// SPDX-License-Identifier: GPL-3.0-or-later
// Islands with meshed blocks: a sparse matrix of nodes and blocks, with a pattern fixed by meshes and contacts.
#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>

#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

class NodalSystem final : public LinearSystem {
 public:
  NodalSystem(const Unknowns& unknowns, const std::vector<std::pair<int, int>>& couples)
      : u_(unknowns), k_(u_.total, u_.total) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto couple = [&](int a, int b) {
      for (const int i : u_.of(a)) {
        for (const int j : u_.of(b)) entries.emplace_back(i, j, 0.0), entries.emplace_back(j, i, 0.0);
      }
    };
    for (int b = 0; b < u_.blocks(); ++b) couple(b, b);
    for (const auto& [a, b] : couples) couple(a, b);
    k_.setFromTriplets(entries.begin(), entries.end());
  }

  void set_zero() override { std::fill_n(k_.valuePtr(), k_.nonZeros(), 0.0); }

  void add(int row, int column, const Matrix6& k) override {
    const Matrix6 mapped = u_.mapped(row, column, k);
    for (std::size_t j = 0; j < u_.of(column).size(); ++j) {
      for (std::size_t i = 0; i < u_.of(row).size(); ++i) {
        k_.coeffRef(u_.of(row)[i], u_.of(column)[j]) +=
            mapped(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
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

  const Unknowns& u_;
  Sparse k_;
  Eigen::CholmodDecomposition<Sparse> cholesky_;
  Eigen::UmfPackLU<Sparse> lu_;
  bool cholesky_ready_ = false;
  bool lu_ready_ = false;
};

}  // namespace

std::unique_ptr<LinearSystem> make_nodal_system(const Unknowns& unknowns,
                                                const std::vector<std::pair<int, int>>& couples) {
  return std::make_unique<NodalSystem>(unknowns, couples);
}

}  // namespace blockweir::solid
