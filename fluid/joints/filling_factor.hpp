// SPDX-License-Identifier: GPL-3.0-or-later
// A factorization for the filling equations, kept from window to window.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <string>

namespace blockweir::joints {

/// Usable as long as the matrix changes little.
class FillingFactor {
 public:
  FillingFactor();
  ~FillingFactor();
  [[nodiscard]] bool fits(const Eigen::SparseMatrix<double>& matrix) const;
  /// False if the matrix is singular.
  bool make(const Eigen::SparseMatrix<double>& matrix);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);
  void keep(bool keeps) { keeps_ = keeps; }
  [[nodiscard]] long count() const { return count_; }  ///< number of factorizations
  [[nodiscard]] long kept() const { return kept_; }    ///< solutions with a reused factorization
  void used_again() { ++kept_; }

 private:
  bool keeps_ = true;
  long kept_ = 0;
  struct Factor;
  std::unique_ptr<Factor> factor_;
  Eigen::SparseMatrix<double> matrix_;  ///< of factor_
  bool made_ = false;
  long count_ = 0;
};

}  // namespace blockweir::joints
