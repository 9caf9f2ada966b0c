// SPDX-License-Identifier: GPL-3.0-or-later
// Small islands: one dense matrix, LU with partial pivoting (a slipping contact makes K unsymmetric).
#include <Eigen/LU>

#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {
namespace {

class DenseSystem final : public LinearSystem {
 public:
  explicit DenseSystem(int blocks) : k_(6 * blocks, 6 * blocks), lu_(6 * blocks) {}

  void set_zero() override { k_.setZero(); }
  void add(int row, int column, const Matrix6& k) override { k_.block<6, 6>(6 * row, 6 * column) += k; }
  bool solve(bool /*symmetric*/, const Eigen::VectorXd& f, Eigen::VectorXd& d) override {
    lu_.compute(k_);
    d = lu_.solve(f);
    return d.allFinite();
  }

 private:
  Eigen::MatrixXd k_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace

std::unique_ptr<LinearSystem> make_dense_system(int blocks) {
  return std::make_unique<DenseSystem>(blocks);
}

std::unique_ptr<LinearSystem> make_linear_system(int blocks, const std::vector<std::pair<int, int>>& couples) {
  constexpr int largest_dense = 12;
  return blocks <= largest_dense ? make_dense_system(blocks) : make_sparse_system(blocks, couples);
}

}  // namespace blockweir::solid
