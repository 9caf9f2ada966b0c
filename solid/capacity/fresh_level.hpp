// SPDX-License-Identifier: GPL-3.0-or-later
// The lowest level at which the blocks find no equilibrium when all loads are applied at once. Each static analysis
// starts from the scene as drawn, like a run or the factor of safety. If dilation is smaller than friction, equilibrium
// is not unique: it depends on the history of the joint forces.
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
  std::optional<Failure> failure;     ///< none if the mode was not found
  std::vector<std::string> warnings;  ///< about the blocks at stands_m
  std::string stopped;                ///< why the bracket is not narrower; empty if it is narrow enough
};

/// None if all of these levels are stable, which costs one analysis each. Otherwise the level is below the lowest one
/// that fails. The structure is at rest at `empty_m`.
std::optional<FreshLevel> fresh_level(const scene::Scene& scene, StillWater& water, SearchBudget& effort,
                                      double empty_m, std::vector<double> levels_m);

}  // namespace blockweir::solid
