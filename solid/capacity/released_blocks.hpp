// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a scene let go as they are drawn, until they have come to rest or failed. This decides where static
// steps only creep: friction that wedges many blocks leaves them no contact states but in the shortest of steps.
#pragma once

#include "solid/capacity/search_budget.hpp"
#include "solid/capacity/still_water.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

class ReleasedBlocks {
 public:
  /// As of StaticBlocks. The loads are those of the scene's end.
  ReleasedBlocks(const scene::Scene& scene, StillWater* water, SearchBudget& effort);

  /// Whether they come to rest, with pressures that follow them, before one of them fails or slips by more than
  /// failure_displacement_m. Throws Undecided where neither happens for a thousand steps, and in an earthquake, whose
  /// ground motion is no steady load.
  bool come_to_rest(double level_m);

  [[nodiscard]] const Solid& solid() const { return solid_; }
  /// Pressures on the blocks at their present positions; empty without water.
  const wire::Load& pressures(double level_m);

 private:
  scene::Scene scene_;  ///< modified for this motion
  Solid solid_;
  StillWater* water_;
  wire::Motion motion_;
};

}  // namespace blockweir::solid
