// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations with contact forces as unknowns besides the displacements, one equation for each force: K d - B f =
// r, R d + compliance f = -violation.
#pragma once

#include <Eigen/SparseCore>

#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {

class SaddlePoint {
 public:
  /// `unknowns` must outlive the object.
  explicit SaddlePoint(const Unknowns& unknowns) : u_(unknowns) {}

  void set_zero();
  /// Adds to the blocks' matrix at local (row, column).
  void add(int row, int column, const Matrix6& k);
  /// Adds a force and starts its equation.
  void add_force(double violation, double compliance);
  /// Effect of the last force on a block, and of the block's displacement on its equation.
  void couple(int block, const Vector6& column, const Vector6& row);
  /// Displacements for a right-hand side `r` of the blocks, and the forces in the order of their addition. False if the
  /// matrix is singular to working accuracy.
  bool solve(const Eigen::VectorXd& r, Eigen::VectorXd& d, Eigen::VectorXd& forces);
  [[nodiscard]] Eigen::MatrixXd dense() const;

 private:
  [[nodiscard]] Eigen::SparseMatrix<double> matrix() const;

  const Unknowns& u_;
  std::vector<Eigen::Triplet<double>> entries_;
  std::vector<double> violations_;
};

}  // namespace blockweir::solid
