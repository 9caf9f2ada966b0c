// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of one island with lagged friction bounds: within a sweep each bound is that of the normal force of the
// sweep before. The increment then minimizes a convex energy, which Newton's method with a line search always finds.
// Sweeps of multipliers and bounds together converge to Coulomb's law (Simo and Laursen 1992, Comput. Struct. 42). An
// interior point method gives the initial contact states.
#pragma once

#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

constexpr double lagging_penalty_ratio = 1e-2;  ///< penalties with lagged friction, over those of the step

class LaggingFriction : StepPart {
 public:
  explicit LaggingFriction(StepWorkspace& step) : StepPart(step) {}

  /// For islands whose contact states cycle with the full law: a slip changes the normal force that bounds it, there
  /// and at its neighbours, and so restores the states with which Newton's method began.
  bool find(IslandEquations& island, const StepMode& mode);

 private:
  enum class Approach { nothing, near, states };  ///< result of the interior point method
  Approach approach(IslandEquations& island, double change_n);
  bool finish(IslandEquations& island, const StepMode& mode);
  bool minimize(IslandEquations& island, int most_solutions);
  double search_along_correction(IslandEquations& island);
};

}  // namespace blockweir::solid
