// SPDX-License-Identifier: GPL-3.0-or-later
// Forces by which many rigid blocks that rest in dry contacts go on resting. Of all admissible forces those farthest
// from their bounds: their analytic centre (Sonnevend 1985), which maximizes the product of the forces along both edges
// of all cones of friction. Newton's method follows it from the forces of the step before in a solution or two. The
// contact states need no search meanwhile: at the centre every contact sticks.
#pragma once

#include <vector>

#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

class CentredForces : StepPart {
 public:
  explicit CentredForces(StepWorkspace& step) : StepPart(step) {}

  /// May the island rest by such forces? Not in steps that settle, and not where forces are not those of hard contacts.
  [[nodiscard]] bool may_hold(const IslandEquations& island, const StepMode& mode) const;

  /// Do such forces hold the island where the step began? They act then. Otherwise the trial and its contacts are left
  /// as they come.
  bool hold(IslandEquations& island);

 private:
  /// Forces along both edges of a cone of friction: shear at its negative and at its positive bound [N per metre].
  struct Cone {
    double friction = 0;
    double minus = 0;
    double plus = 0;
    double minus_change = 0;
    double plus_change = 0;

    [[nodiscard]] bool open() const { return minus == 0; }
    [[nodiscard]] Eigen::Vector2d force() const { return {minus + plus, friction * (plus - minus)}; }
  };

  bool begin(IslandEquations& island);
  void set_stiffnesses(IslandEquations& island);
  bool find_changes(IslandEquations& island);
  [[nodiscard]] bool none_can_hold(const IslandEquations& island) const;
  void change(IslandEquations& island);
  [[nodiscard]] double positive_fraction() const;
  void take(IslandEquations& island);

  std::vector<Cone> cones_;  ///< of the island's contacts; without friction and forces: open ones
  Eigen::VectorXd loads_;
  double share_ = 0;  ///< of the forces' squares: what makes stiffnesses of them, large against inertia
};

}  // namespace blockweir::solid
