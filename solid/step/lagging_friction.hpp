// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of one island with friction bounds that lag: within a sweep each is what the normal force of the sweep
// before allows, so that the increment minimizes a convex energy, and Newton's method with a line search always finds
// it. Sweeps of multipliers and bounds together lead to Coulomb's law (Simo and Laursen 1992, Comput. Struct. 42). An
// interior point method finds the states to begin with.
#pragma once

#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

constexpr double lagging_penalty_ratio = 1e-2;  ///< penalties while friction lags, of a step's own

class LaggingFriction : StepPart {
 public:
  explicit LaggingFriction(StepWorkspace& step) : StepPart(step) {}

  /// For where the states of the whole law run in circles: a slip changes the normal force that bounds it, there and at
  /// its neighbours, and brings the states back with which Newton's method began.
  bool find(IslandEquations& island, const StepMode& mode);

 private:
  enum class Approach { nothing, near, states };  ///< what the interior point has come to
  Approach approach(IslandEquations& island, double change_n);
  bool finish(IslandEquations& island, const StepMode& mode);
  bool minimize(IslandEquations& island, int most_solutions);
  double search_along_correction(IslandEquations& island);
};

}  // namespace blockweir::solid
