// SPDX-License-Identifier: GPL-3.0-or-later
// Forces by which blocks that begin to move do so under Coulomb's law. Sweeps need thousands of rounds for what moves
// slowly in a large wall: a force goes on by one block in each.
#pragma once

#include "solid/solve/cone_forces.hpp"

namespace blockweir::solid {

class MovingForces {
 public:
  /// As ConeForces has them.
  MovingForces(const ForceSweeps& sweeps, const Unknowns& unknowns, const std::vector<Matrix6>& matrix)
      : forces_(sweeps, unknowns, matrix) {}

  /// Under `loads`, forces on the unknowns: by how much the nearest forces found are off their laws [m], that at most
  /// where it could be, and a thousandth of it where that takes few solutions.
  double find(const Eigen::VectorXd& loads, double enough_m);
  /// Normal and shear of a row, inside its cone of friction [N per metre].
  [[nodiscard]] Eigen::Vector2d force(std::size_t row) const { return forces_.force(row); }
  [[nodiscard]] int solutions() const { return forces_.solutions(); }

 private:
  [[nodiscard]] double smooth_m(double left_m) const;

  ConeForces forces_;
};

}  // namespace blockweir::solid
