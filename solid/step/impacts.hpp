// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts are not smooth. A second-order scheme uses the forces at the start of the step, which an impact changes, and
// so produces energy. Steps in which contacts change are therefore made by Shi's scheme, which dissipates.
#pragma once

#include <vector>

#include "solid/step/step_methods.hpp"

namespace blockweir::solid {

class StepsWithImpacts : StepPart {
 public:
  StepsWithImpacts(StepWorkspace& step, TimeStep& time_step, const WaterInertia& water)
      : StepPart(step), time_step_(time_step), methods_(step, time_step), water_(water) {}

  /// Second-order schemes need an initial acceleration: a step of Shi's scheme, undone afterwards, gives it.
  void start_acceleration(const std::vector<Panel>& water, double from_s);
  /// A step by the scene's integrator, or by Shi's scheme if contacts close, open, or start or stop slipping in it, and
  /// for one more step, whose acceleration is that of the acting forces.
  Outcome make(const Stretch& stretch);
  /// Whether Shi's scheme made the last step.
  [[nodiscard]] bool made_by_shi() const { return made_by_shi_; }

 private:
  TimeStep& time_step_;
  StepMethods methods_;
  const WaterInertia& water_;
  bool made_by_shi_ = true;
};

}  // namespace blockweir::solid
