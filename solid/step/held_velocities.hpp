// SPDX-License-Identifier: GPL-3.0-or-later
// All integrators here turn a velocity that is held into its opposite, undamped: such velocities are settled after the
// step by what holds them.
#pragma once

#include <vector>

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

class HeldVelocities : StepPart {
 public:
  explicit HeldVelocities(Step& step) : StepPart(step) {}

  /// Velocities along held directions (closed contacts, sticking ones along the edge too, supports) become those of
  /// what holds them; the velocities get the smallest change, in the metric of the step's matrix, that does so.
  /// Friction of a slipping contact has no part in it: with that coupling the projection could grow what it should
  /// remove. Where the scene's integrator is Shi's, of first order, they become the step's mean instead, which needs no
  /// rate of what leads.
  void settle(IslandEquations& island, double dt);

  /// Of a base that moves, as velocities that it holds become: the step's mean, or that of its end.
  [[nodiscard]] Point base_velocity(double dt) const;

 private:
  void settle_solved(IslandEquations& island, double dt);
  void settle_swept(IslandEquations& island, double dt);
  void project(IslandEquations& island, const std::vector<Eigen::Vector2d>& missing);
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
