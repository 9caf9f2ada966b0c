// SPDX-License-Identifier: GPL-3.0-or-later
// Block Gauss-Seidel on forces: each contact in turn gets the forces that fulfil its law while all others stand. After
// any number of sweeps forces are admissible, and displacements are those that they cause.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "solid/contact/force_rule.hpp"

namespace blockweir::solid {

class ForceSweeps {
 public:
  /// What one end of a force meets: unknowns that follow each other.
  struct End {
    Eigen::Index first = 0;
    Eigen::Index count = 0;       ///< 0: what does not move
    std::size_t first_entry = 0;  ///< of its motions, then responses
  };
  struct Row {
    std::array<End, 2> ends;
    Eigen::Matrix2d flexibility = Eigen::Matrix2d::Zero();  ///< of gap and slip, by the row's own forces
    Eigen::Vector2d apart = Eigen::Vector2d::Zero();        ///< gap and slip without a displacement [m]
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    ForceRule rule{};
    bool slips = false;  ///< shear is at its bound
  };

  /// No rows, and displacements that there are without forces.
  void begin(const Eigen::VectorXd& displacement);
  Row& add_row() { return rows_.emplace_back(); }
  /// One end of the last row. Rows of `motions`: d (gap, slip) / d unknowns; columns of `responses`: displacements by
  /// unit forces.
  void add_end(bool second, Eigen::Index first, const Eigen::Matrix2Xd& motions, const Eigen::MatrixX2d& responses);
  /// Displacements by the forces that rows have.
  void let_act();
  /// Rows stay, displacements begin anew.
  void displace(const Eigen::VectorXd& displacement) { displacement_ = displacement; }

  /// Forces go that share of their way; admissible ones stay so. Largest change of a gap or slip by a row's own forces
  /// [m].
  double sweep(double share = 1);
  /// By how much gaps and slips are off their laws [m].
  [[nodiscard]] double residual() const;
  [[nodiscard]] Eigen::Vector2d apart(const Row& row) const;

  [[nodiscard]] const Eigen::VectorXd& displacement() const { return displacement_; }
  [[nodiscard]] std::vector<Row>& rows() { return rows_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  void act(const Row& row, double normal, double shear);

  std::vector<Row> rows_;
  std::vector<double> entries_;
  Eigen::VectorXd displacement_;
};

}  // namespace blockweir::solid
