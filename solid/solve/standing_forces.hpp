// SPDX-License-Identifier: GPL-3.0-or-later
// Forces by which blocks at rest stay there, if any do. With associated flow (what slips opens by the tangent of
// friction) the motion of a step is that of a convex problem; if nothing slips in it, its forces fulfil Coulomb's law,
// too. Some 15 solutions find them. Sweeps, whose forces creep through the structure, would let it slip meanwhile.
#pragma once

#include "solid/solve/cone_forces.hpp"

namespace blockweir::solid {

class StandingForces {
 public:
  /// As ConeForces has them.
  StandingForces(const ForceSweeps& sweeps, const Unknowns& unknowns, const std::vector<Matrix6>& matrix)
      : forces_(sweeps, unknowns, matrix) {}

  /// Under `loads`, forces on the unknowns: whether nothing that presses slips by more than that [m]. What opens may.
  bool found(const Eigen::VectorXd& loads, double enough_m);
  /// Normal and shear of a row, inside its cone of friction [N per metre].
  [[nodiscard]] Eigen::Vector2d force(std::size_t row) const { return forces_.force(row); }
  [[nodiscard]] int solutions() const { return forces_.solutions(); }

 private:
  [[nodiscard]] bool stands(double enough_m) const;
  [[nodiscard]] double lost_in_slip() const;

  ConeForces forces_;
};

}  // namespace blockweir::solid
