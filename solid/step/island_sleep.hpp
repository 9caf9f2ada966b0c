// SPDX-License-Identifier: GPL-3.0-or-later
// Islands at rest under constant loads: a step skips them.
#pragma once

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

class IslandSleep : StepPart {
 public:
  explicit IslandSleep(StepWorkspace& step) : StepPart(step) {}

  [[nodiscard]] bool may_begin(const IslandEquations& island, const StepMode& mode) const;
  void begin(IslandEquations& island);
};

}  // namespace blockweir::solid
