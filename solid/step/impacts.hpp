// SPDX-License-Identifier: GPL-3.0-or-later
// An impact is not a smooth motion. A rule of second order weighs the forces of the step's beginning, which an impact
// does not continue, and makes energy of it: steps in which contacts change are made by Shi's scheme, which takes.
#pragma once

#include <vector>

#include "solid/step/step_methods.hpp"

namespace blockweir::solid {

class StepsWithImpacts : StepPart {
 public:
  StepsWithImpacts(StepWorkspace& step, TimeStep& time_step, const WaterInertia& water)
      : StepPart(step), time_step_(time_step), methods_(step, time_step), water_(water) {}

  /// Second-order schemes need the acceleration that the run starts with: a step of Shi's scheme, undone, gives it.
  void start_acceleration(const std::vector<Panel>& water, double from_s);
  /// A step by the scene's integrator; by Shi's scheme where contacts close, open, begin or cease to slip in it, and
  /// for one more, whose acceleration is that of the forces that act.
  Outcome make(const Stretch& stretch);
  /// The last step.
  [[nodiscard]] bool made_by_shi() const { return made_by_shi_; }

 private:
  TimeStep& time_step_;
  StepMethods methods_;
  const WaterInertia& water_;
  bool made_by_shi_ = true;
};

}  // namespace blockweir::solid
