// SPDX-License-Identifier: GPL-3.0-or-later
// Static analysis, and the end of each window of a quasi-static one: steps until what is unbalanced is small, or the
// structure is on the move.
#pragma once

#include <vector>

#include "solid/step/step_methods.hpp"

namespace blockweir::solid {

class StaticAnalysis : StepPart {
 public:
  StaticAnalysis(StepWorkspace& step, TimeStep& time_step)
      : StepPart(step), time_step_(time_step), methods_(step, time_step) {}

  /// Steps under loads of that time; what has been found is in the state.
  void come_to_rest(const std::vector<Panel>& water, double at_s);
  /// Of the last step, over the weight. With velocities reset at every step, inertia is what the forces leave
  /// unbalanced.
  [[nodiscard]] double unbalanced_ratio() const;

 private:
  TimeStep& time_step_;
  StepMethods methods_;
};

}  // namespace blockweir::solid
