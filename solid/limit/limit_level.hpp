// SPDX-License-Identifier: GPL-3.0-or-later
// The water level at which limit analysis fails. Forces of water are no multiple of each other at two levels, so the
// level comes from mechanisms: at a level that fails, the program's mechanism; the level at which that mechanism's
// power vanishes is lower and fails, too, or is the one. Levels come down monotonically and end after a few programs.
#pragma once

#include <functional>

#include "solid/limit/level_range.hpp"
#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid::limit {

/// Forces of all water with the reservoir at that level [m].
using WaterAtLevel = std::function<Wrenches(double level_m)>;

struct LimitLevel {
  Filled outcome = Filled::does_not_stand_empty;
  double level_m = 0;   ///< where it fails; else that of the full reservoir
  LargestFactor at_it;  ///< of the reservoir's forces at that level; its mechanism alone where it does not stand empty
  int programs = 0;     ///< solved
};

LimitLevel limit_level(const LimitAnalysis& structure, const Wrenches& dead, const WaterAtLevel& water,
                       const LevelRange& range);

}  // namespace blockweir::solid::limit
