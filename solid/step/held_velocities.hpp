// SPDX-License-Identifier: GPL-3.0-or-later
// All integrators here turn a velocity that is held into its opposite, undamped: such velocities are settled after the
// step by what holds them.
#pragma once

#include <vector>

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

class HeldVelocities : StepPart {
 public:
  explicit HeldVelocities(StepWorkspace& step) : StepPart(step) {}

  /// Velocities along held directions (closed contacts, sticking ones along the edge too, supports) become those of
  /// what holds them; the velocities get the smallest change, in the metric of the step's matrix, that does so. Where
  /// that takes friction that contacts do not have, as at an impact, all impulses of the step fulfil Coulomb's law.
  /// Where the scene's integrator is Shi's, of first order, they become the step's mean instead, which needs no rate of
  /// what leads.
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
  [[nodiscard]] bool to_mean() const {
    return model_.scene.analysis.integrator == scene::Integrator::shi || !trial_.scheme.damps;
  }
  /// By how much the joint of an action that dilates opens as it slips.
  [[nodiscard]] double opening_slope(const IslandEquations& island, std::size_t action) const;
  /// Of a support by its table and the base; contacts are not led.
  [[nodiscard]] Eigen::Vector2d led_rate(const IslandEquations& island, std::size_t action, double dt) const;
  [[nodiscard]] Eigen::Vector2d rate_of_fixed(const Interaction& action, double dt) const;
};

}  // namespace blockweir::solid
