// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that go from rest to motion, at the start or, if rigid, in a step. Friction and redundant contacts leave their
// forces open: those of held joints, or of the step before, may lead to a slip, from one step length and not from
// another, under loads that the blocks bear. What can stay is told as by a static analysis: by slips without velocity,
// until forces balance or it moves on.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "solid/step/static_analysis.hpp"

namespace blockweir::solid {

class MotionFromRest : StepPart {
 public:
  MotionFromRest(StepWorkspace& step, StaticAnalysis& statics) : StepPart(step), statics_(statics) {}

  /// Of a structure that no settling steps have brought to rest: does statics find a state of rest for it?
  [[nodiscard]] bool starts_at_rest(const std::vector<Panel>& water);
  /// Before a step.
  void begin_step(double dt);
  /// After a step that was made: where it began a motion and statics finds a state of rest within hardly any slip, that
  /// is the step's end.
  void end_step(double dt, const std::vector<Panel>& water, double at_s);

 private:
  struct Search {
    int most_steps;
    double farthest;  ///< that a block may go to a state of rest, over failure_displacement_m
  };
  /// What finds a state of rest makes one step, seldom five on the way and eight at the start.
  static constexpr Search at_start = {.most_steps = 10, .farthest = 1};
  static constexpr Search on_the_way = {.most_steps = 30, .farthest = 0.1};

  [[nodiscard]] bool follows_forces() const;
  [[nodiscard]] bool moves_by_itself() const;
  [[nodiscard]] std::ptrdiff_t moving_blocks() const;
  [[nodiscard]] bool is_held() const;
  [[nodiscard]] bool rests_by_statics(const std::vector<Panel>& water, double at_s, const Search& search);

  StaticAnalysis& statics_;
  std::optional<bool> follows_;  ///< none before the first step
  bool rested_ = false;          ///< as the step began
  Standing before_;
  EnergyBalance balance_before_;
};

}  // namespace blockweir::solid
