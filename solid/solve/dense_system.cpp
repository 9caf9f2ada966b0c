// SPDX-License-Identifier: GPL-3.0-or-later
// Small islands: one dense matrix, LU with partial pivoting (a slipping contact makes K unsymmetric).
#include <Eigen/LU>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/solve/linear_system.hpp"
#include "solid/solve/sparse_solvers.hpp"

namespace blockweir::solid {
namespace {

class DenseSystem final : public LinearSystem {
 public:
  explicit DenseSystem(const Unknowns& unknowns) : u_(unknowns), k_(u_.total, u_.total), lu_(u_.total) {}

  void set_zero() override { k_.setZero(); }
  void add(int row, int column, const Matrix6& k) override {
    const int rows = u_.count[at(row)];
    const int columns = u_.count[at(column)];
    k_.block(u_.first[at(row)], u_.first[at(column)], rows, columns) += k.topLeftCorner(rows, columns);
  }
  void set_beside(LowRank beside) override {
    if (!beside.none()) k_ += beside.U * beside.S * beside.U.transpose();
  }
  bool solve(bool /*symmetric*/, const Eigen::VectorXd& f, Eigen::VectorXd& d) override {
    {
      const Stopwatch watch(times_.factorization);
      lu_.compute(k_);
    }
    d = lu_.solve(f);
    return d.allFinite();
  }
  [[nodiscard]] SolutionTimes times() const override { return times_; }
  [[nodiscard]] Eigen::VectorXd solve_again(const Eigen::VectorXd& f) override { return lu_.solve(f); }
  [[nodiscard]] Eigen::MatrixXd dense() const override { return k_; }

 private:
  Unknowns u_;
  Eigen::MatrixXd k_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  SolutionTimes times_;
};

}  // namespace

std::unique_ptr<LinearSystem> make_dense_system(const Unknowns& unknowns) {
  return std::make_unique<DenseSystem>(unknowns);
}

std::unique_ptr<LinearSystem> make_linear_system(const Unknowns& unknowns,
                                                 const std::vector<std::pair<int, int>>& couples) {
  constexpr int largest_dense = 72;  // unknowns: 12 deformable blocks
  if (unknowns.shared()) return sparse_solvers().make_nodal_system(unknowns, couples);
  if (unknowns.total <= largest_dense) return make_dense_system(unknowns);
  return sparse_solvers().make_sparse_system(unknowns, couples);
}

}  // namespace blockweir::solid
