// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a step that has been found: what its blocks, contacts and energies become.
#pragma once

#include "solid/step/step_islands.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

class StepEnd : StepPart {
 public:
  StepEnd(StepWorkspace& step, StepIslands& islands, WaterInertia& water)
      : StepPart(step), islands_(islands), water_(water) {}

  /// Does any contact slip, or any block lie otherwise than the step had it?
  bool accept(const Stretch& stretch, const StepMode& mode);
  /// Soon after an impact a smooth step may make energy that no motion is there to give back. Only looked at: all is
  /// put back as it was.
  [[nodiscard]] bool affords_motion(double dt);

 private:
  void accept_motion(IslandEquations& island, double dt);
  void act_by_end_rates(std::size_t b, double dt);

  StepIslands& islands_;
  WaterInertia& water_;
};

}  // namespace blockweir::solid
