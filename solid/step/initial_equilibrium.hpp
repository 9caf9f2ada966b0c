// SPDX-License-Identifier: GPL-3.0-or-later
// The state at time 0: weight and first loads are carried, all touching joints held, everything is at rest.
#pragma once

#include <vector>

#include "solid/step/step_methods.hpp"

namespace blockweir::solid {

class InitialEquilibrium : StepPart {
 public:
  InitialEquilibrium(StepWorkspace& step, TimeStep& time_step)
      : StepPart(step), time_step_(time_step), methods_(step, time_step) {}

  /// Lets weight and first loads settle with all joints held, then releases them. False if the structure is moving
  /// afterwards. Throws SolveError if there is no equilibrium.
  bool settle(const std::vector<Panel>& water);

 private:
  void set(const FormulationSettings& settings);
  void hold(const Stretch& pseudo_step, const StepMode& mode, FormulationSettings& held);
  bool relax(const Stretch& pseudo_step, const StepMode& mode);
  void forget_locked_forces();
  void start_moving(const Stretch& pseudo_step, double acceleration, const Standing& held, const StepMode& mode);

  TimeStep& time_step_;
  StepMethods methods_;
};

/// Blocks without a chain of touching contacts and bolts to the ground or to a support.
std::vector<bool> unanchored(const Model& model, const State& state);

}  // namespace blockweir::solid
