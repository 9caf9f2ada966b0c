// SPDX-License-Identifier: GPL-3.0-or-later
// The correction of a sparse matrix's factors for a low-rank matrix beside it.
#pragma once

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>

#include "solid/solve/low_rank.hpp"

namespace blockweir::solid {

/// U S U^T d.
inline Eigen::VectorXd product(const LowRank& beside, const Eigen::VectorXd& d) {
  return beside.U * (beside.S * (beside.U.transpose() * d));
}

/// (K + U S U^T)^-1 = K^-1 - X (I + S X^T U)^-1 S U^T K^-1 with X = K^-1 U, for a factorized K.
class WoodburyCorrection {
 public:
  /// Is X up to date for this U and S?
  [[nodiscard]] bool made_for(const LowRank& beside) const {
    return X_.rows() == beside.U.rows() && X_.cols() == beside.U.cols() && S_ == beside.S && same(U_, beside.U);
  }
  void forget() { X_.resize(0, 0); }

  template <class Solver>
  void make(const Solver& solver, const LowRank& beside) {
    U_ = beside.U;
    S_ = beside.S;
    X_ = solver.solve(Eigen::MatrixXd(U_));
    core_.compute(Eigen::MatrixXd::Identity(S_.rows(), S_.cols()) + S_ * (U_.transpose() * X_));
  }

  /// Turns a solution with K into one with K + U S U^T.
  void correct(Eigen::VectorXd& d) const { d -= X_ * core_.solve(S_ * (U_.transpose() * d)); }

 private:
  static bool same(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
    const auto equal = [](const auto* first, const auto* other, Eigen::Index size) {
      return std::equal(first, first + size, other);
    };
    return a.nonZeros() == b.nonZeros() && equal(a.outerIndexPtr(), b.outerIndexPtr(), a.outerSize() + 1) &&
           equal(a.innerIndexPtr(), b.innerIndexPtr(), a.nonZeros()) && equal(a.valuePtr(), b.valuePtr(), a.nonZeros());
  }

  Eigen::SparseMatrix<double> U_;
  Eigen::MatrixXd S_;
  Eigen::MatrixXd X_;
  Eigen::PartialPivLU<Eigen::MatrixXd> core_;
};

}  // namespace blockweir::solid
