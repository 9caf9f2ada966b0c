// SPDX-License-Identifier: GPL-3.0-or-later
// Static analysis, and the end of each window of a quasi-static one: steps until the unbalanced force is small, or the
// structure is moving.
#pragma once

#include <vector>

#include "solid/step/step_methods.hpp"

namespace blockweir::solid {

class StaticAnalysis : StepPart {
 public:
  StaticAnalysis(StepWorkspace& step, TimeStep& time_step)
      : StepPart(step), time_step_(time_step), methods_(step, time_step) {}

  /// Steps under the loads of that time, once supports stand where they do then; the result is in the state.
  void come_to_rest(const std::vector<Panel>& water, double at_s, int most_steps = 1000);
  /// Is it proved that no admissible forces hold the blocks where they are? Only of many rigid ones
  /// (step/centred_forces).
  bool must_move(const std::vector<Panel>& water, double at_s);
  /// Unbalanced force of the last step over the weight. Velocities are reset at every step, so that inertia equals the
  /// unbalanced force.
  [[nodiscard]] double unbalanced_ratio() const;

 private:
  struct Search {
    int most_steps;
    double balanced;  ///< largest unbalanced force of a state of rest, over the weight
  };

  /// Leads supports from where the scene draws them to where they stand at that time, joints slipping and opening on
  /// the way. Once they are there it does nothing. False if something fails on the way; throws SolveError if no states
  /// are found on it.
  bool lead_supports(const std::vector<Panel>& water, double at_s);
  void find_rest(const std::vector<Panel>& water, double at_s, const Search& search);

  TimeStep& time_step_;
  StepMethods methods_;
};

}  // namespace blockweir::solid
