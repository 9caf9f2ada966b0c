// SPDX-License-Identifier: GPL-3.0-or-later
// All integrators here reverse a velocity in a constrained direction, undamped: such velocities are corrected after the
// step.
#pragma once

#include <vector>

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

class ConstrainedVelocities : StepPart {
 public:
  explicit ConstrainedVelocities(StepWorkspace& step) : StepPart(step) {}

  /// Velocities in constrained directions (closed contacts, for sticking ones also tangentially, supports) become
  /// those of the constraint; the change of the velocities is the smallest in the metric of the step's matrix. If that
  /// would need friction that contacts do not have, as at an impact, all impulses of the step satisfy Coulomb's law.
  /// With the step's mean rates, half a step behind, Shi's scheme would make the force of whatever turns a constraint
  /// or leads it count twice.
  void settle(IslandEquations& island, double dt);

 private:
  bool settle_solved(IslandEquations& island, double dt);
  bool project(IslandEquations& island, const std::vector<Eigen::Vector2d>& missing);
  [[nodiscard]] bool friction_has(const IslandEquations& island, const std::vector<Eigen::Vector2d>& missing,
                                  double dt) const;
  void set_rows(IslandEquations& island);
  void settle_by_impulses(IslandEquations& island, double dt);
  void rule_of_contact(ForceSweeps::Row& row, double opening, double dt) const;
  [[nodiscard]] double impulse_per_force(double dt) const;
  /// Opening of a dilating joint per unit of slip.
  [[nodiscard]] double opening_slope(const IslandEquations& island, std::size_t action) const;
  /// Prescribed velocity of a support, from its table and the base; zero for contacts.
  [[nodiscard]] Eigen::Vector2d led_rate(const IslandEquations& island, std::size_t action, double dt) const;
  [[nodiscard]] Eigen::Vector2d rate_of_fixed(const Interaction& action) const;
};

}  // namespace blockweir::solid
