// SPDX-License-Identifier: GPL-3.0-or-later
// The lowest level at which the blocks find no rest where all loads come at once: static analyses that each begin anew
// from the scene's outline, as those of a run and of the factor of safety do. With friction that dilates less than it
// rubs, equilibrium is not unique: it depends on how the joints' forces came about.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solid/capacity/search_budget.hpp"
#include "solid/capacity/still_water.hpp"
#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {

struct FreshLevel {
  double stands_m = 0;
  double fails_m = 0;
  std::optional<Failure> failure;  ///< how; none where that was not seen
  std::string warning;             ///< of the blocks at stands_m; empty: none
  std::string stopped;             ///< why the bracket is no narrower; empty where it is as narrow as it is to be
};

/// None where all of these levels stand, which costs an analysis each; else what is looked for is below the lowest that
/// fails. They rest under `empty_m`.
std::optional<FreshLevel> fresh_level(const scene::Scene& scene, StillWater& water, SearchBudget& effort,
                                      double empty_m, std::vector<double> levels_m);

}  // namespace blockweir::solid
