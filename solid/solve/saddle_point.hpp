// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks' own matrices with forces as unknowns beside the displacements, one equation for each force:
// K d - B f = r, R d + compliance f = -violation.
#pragma once

#include <Eigen/SparseCore>

#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {

class SaddlePoint {
 public:
  /// The unknowns must outlive it.
  explicit SaddlePoint(const Unknowns& unknowns) : u_(unknowns) {}

  void set_zero();
  /// Adds to the blocks' own matrix at local (row, column).
  void add(int row, int column, const Matrix6& k);
  /// A new force: begins its equation.
  void add_force(double violation, double compliance);
  /// What the latest force does to a block, and what the block's displacement does to its equation.
  void couple(int block, const Vector6& column, const Vector6& row);
  /// Displacements for a right-hand side `r` of the blocks, and the forces in the order in which they were added.
  /// False when the matrix is singular to working accuracy.
  bool solve(const Eigen::VectorXd& r, Eigen::VectorXd& d, Eigen::VectorXd& forces);
  [[nodiscard]] Eigen::MatrixXd dense() const;

 private:
  [[nodiscard]] Eigen::SparseMatrix<double> matrix() const;

  const Unknowns& u_;
  std::vector<Eigen::Triplet<double>> entries_;
  std::vector<double> violations_;
};

}  // namespace blockweir::solid
