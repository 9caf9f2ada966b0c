// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/saddle_point.hpp"

#include <Eigen/LU>

#include "solid/solve/sparse_solvers.hpp"

namespace blockweir::solid {
void SaddlePoint::set_zero() {
  entries_.clear();
  violations_.clear();
}

void SaddlePoint::add(int row, int column, const Matrix6& k) {
  const Matrix6 mapped = u_.mapped(row, column, k);
  for (std::size_t j = 0; j < u_.of(column).size(); ++j) {
    for (std::size_t i = 0; i < u_.of(row).size(); ++i) {
      entries_.emplace_back(u_.of(row)[i], u_.of(column)[j],
                            mapped(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
}

void SaddlePoint::add_force(double violation, double compliance) {
  const int unknown = u_.total + static_cast<int>(violations_.size());
  violations_.push_back(violation);
  entries_.emplace_back(unknown, unknown, compliance);
}

void SaddlePoint::couple(int block, const Vector6& column, const Vector6& row) {
  const int unknown = u_.total + static_cast<int>(violations_.size()) - 1;
  const Vector6 push = u_.mapped(block, column);
  const Vector6 violated = u_.mapped(block, row);
  for (std::size_t i = 0; i < u_.of(block).size(); ++i) {
    entries_.emplace_back(u_.of(block)[i], unknown, -push[static_cast<Eigen::Index>(i)]);
    entries_.emplace_back(unknown, u_.of(block)[i], violated[static_cast<Eigen::Index>(i)]);
  }
}

Eigen::SparseMatrix<double> SaddlePoint::matrix() const {
  const int n = u_.total + static_cast<int>(violations_.size());
  Eigen::SparseMatrix<double> K(n, n);
  K.setFromTriplets(entries_.begin(), entries_.end());
  return K;
}

Eigen::MatrixXd SaddlePoint::dense() const {
  return matrix();
}

bool SaddlePoint::solve(const Eigen::VectorXd& r, Eigen::VectorXd& d, Eigen::VectorXd& forces) {
  constexpr int largest_dense = 100;
  const auto count = static_cast<Eigen::Index>(violations_.size());
  Eigen::VectorXd f(u_.total + count);
  f << r, -Eigen::VectorXd::Map(violations_.data(), count);
  const Eigen::SparseMatrix<double> K = matrix();
  Eigen::VectorXd x;
  if (f.size() <= largest_dense) {
    x = Eigen::MatrixXd(K).partialPivLu().solve(f);
  } else {
    if (!sparse_solvers().solve_once(K, f, x)) return false;
  }
  d = x.head(u_.total);
  forces = x.tail(count);
  return x.allFinite();
}

}  // namespace blockweir::solid
