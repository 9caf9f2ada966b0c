// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/saddle_point.hpp"

#include <Eigen/LU>
#include <Eigen/UmfPackSupport>

namespace blockweir::solid {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

void SaddlePoint::set_zero() {
  entries_.clear();
  violations_.clear();
}

void SaddlePoint::add(int block, const Matrix6& k) {
  const int first = u_.first[at(block)];
  for (int j = 0; j < u_.count[at(block)]; ++j) {
    for (int i = 0; i < u_.count[at(block)]; ++i) entries_.emplace_back(first + i, first + j, k(i, j));
  }
}

void SaddlePoint::add_force(double violation, double compliance) {
  const int unknown = u_.total + static_cast<int>(violations_.size());
  violations_.push_back(violation);
  entries_.emplace_back(unknown, unknown, compliance);
}

void SaddlePoint::couple(int block, const Vector6& column, const Vector6& row) {
  const int unknown = u_.total + static_cast<int>(violations_.size()) - 1;
  for (int i = 0; i < u_.count[at(block)]; ++i) {
    entries_.emplace_back(u_.first[at(block)] + i, unknown, -column[i]);
    entries_.emplace_back(unknown, u_.first[at(block)] + i, row[i]);
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
    const Eigen::UmfPackLU<Eigen::SparseMatrix<double>> lu(K);
    if (lu.info() != Eigen::Success) return false;
    x = lu.solve(f);
  }
  d = x.head(u_.total);
  forces = x.tail(count);
  return x.allFinite();
}

}  // namespace blockweir::solid
