// SPDX-License-Identifier: GPL-3.0-or-later
// A factor of the matrix of filling equations, kept from window to window.
#pragma once

#include <Eigen/SparseLU>
#include <string>

namespace blockweir::joints {

/// Serves as long as the matrix is little other.
class FillingFactor {
 public:
  [[nodiscard]] bool fits(const Eigen::SparseMatrix<double>& matrix) const;
  /// False where the matrix is singular.
  bool make(const Eigen::SparseMatrix<double>& matrix);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) { return factor_.solve(right); }
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);
  void keep(bool keeps) { keeps_ = keeps; }
  [[nodiscard]] long count() const { return count_; }  ///< factors made
  [[nodiscard]] long kept() const { return kept_; }    ///< solutions by a factor of one before
  void used_again() { ++kept_; }

 private:
  bool keeps_ = true;
  long kept_ = 0;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factor_;
  Eigen::SparseMatrix<double> of_;
  bool made_ = false;
  long count_ = 0;
};

}  // namespace blockweir::joints
