// SPDX-License-Identifier: GPL-3.0-or-later
// LU by KLU of matrices with one pattern, whose pivots all stay on the diagonal. So the first factors have the pattern
// of all: to fill it anew takes a sixth of the time (378 and 798 unknowns of walls: 0.11 and 0.48 ms for 0.67 and 2.7).
#pragma once

#include <klu.h>

#include <Eigen/SparseCore>

namespace blockweir::solid {

class DiagonalLu {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  DiagonalLu() {
    klu_defaults(&common_);
    common_.tol = 0;  // a share of the largest entry of its column, from which on the diagonal's is the pivot
  }
  ~DiagonalLu() {
    klu_free_numeric(&factors_, &common_);
    klu_free_symbolic(&order_, &common_);
  }
  DiagonalLu(const DiagonalLu&) = delete;
  DiagonalLu& operator=(const DiagonalLu&) = delete;

  /// Once, compressed.
  void analyzePattern(const Matrix& k) { order_ = klu_analyze(size(k), columns(k), rows(k), &common_); }

  void factorize(const Matrix& k) {
    if (order_ == nullptr) return;
    if (factors_ != nullptr && klu_refactor(columns(k), rows(k), values(k), order_, factors_, &common_) == 1) return;
    klu_free_numeric(&factors_, &common_);
    factors_ = klu_factor(columns(k), rows(k), values(k), order_, &common_);
  }

  /// A pivot of zero is no success.
  [[nodiscard]] Eigen::ComputationInfo info() const {
    return factors_ != nullptr && common_.status == KLU_OK ? Eigen::Success : Eigen::NumericalIssue;
  }

  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const {
    Eigen::MatrixXd d = f;
    klu_solve(order_, factors_, static_cast<int>(d.rows()), static_cast<int>(d.cols()), d.data(), &common_);
    return d;
  }

 private:
  static int size(const Matrix& k) { return static_cast<int>(k.cols()); }
  // KLU writes none of these.
  static int* columns(const Matrix& k) { return const_cast<int*>(k.outerIndexPtr()); }
  static int* rows(const Matrix& k) { return const_cast<int*>(k.innerIndexPtr()); }
  static double* values(const Matrix& k) { return const_cast<double*>(k.valuePtr()); }

  mutable klu_common common_{};
  klu_symbolic* order_ = nullptr;
  klu_numeric* factors_ = nullptr;
};

}  // namespace blockweir::solid
