// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a successful step: updates blocks, contacts and energies.
#pragma once

#include "solid/step/step_islands.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

class StepEnd : StepPart {
 public:
  StepEnd(StepWorkspace& step, StepIslands& islands, WaterInertia& water)
      : StepPart(step), islands_(islands), water_(water) {}

  /// Whether a contact slips, or a block ends up differently from the trial.
  bool accept(const Stretch& stretch, const StepMode& mode);
  /// Shortly after an impact a smooth step may produce more energy than the motion can give back. This only checks; the
  /// state is restored.
  [[nodiscard]] bool affords_motion(double dt);

 private:
  void accept_motion(IslandEquations& island, double dt);
  void act_by_end_rates(std::size_t b, double dt);

  StepIslands& islands_;
  WaterInertia& water_;
};

}  // namespace blockweir::solid
