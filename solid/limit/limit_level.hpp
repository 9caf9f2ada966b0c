// SPDX-License-Identifier: GPL-3.0-or-later
// The failure level by limit analysis. Water forces at two levels are not multiples of each other, so the level is
// found by mechanisms: take the mechanism at a level that fails. The level at which its power vanishes is lower and
// also fails, or is the result. The levels decrease monotonically and end after a few programs. Where a scene has
// several structures, each one's top is such a level to start from, from the lowest on.
#pragma once

#include <functional>

#include "solid/limit/level_range.hpp"
#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid::limit {

/// Forces of all water with the reservoir at this level [m].
using WaterAtLevel = std::function<Wrenches(double level_m)>;

struct LimitLevel {
  Filled outcome = Filled::does_not_stand_empty;
  double level_m = 0;   ///< at failure; without failure, the full reservoir
  LargestFactor at_it;  ///< for the reservoir's forces at level_m; mechanism only, if it fails when empty
  int programs = 0;     ///< number of programs solved
};

LimitLevel limit_level(const LimitAnalysis& structure, const Wrenches& dead, const WaterAtLevel& water,
                       const LevelRange& range);

}  // namespace blockweir::solid::limit
