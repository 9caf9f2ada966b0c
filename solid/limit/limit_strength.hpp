// SPDX-License-Identifier: GPL-3.0-or-later
// Strength reduction by limit analysis: the factor by which c and tan(phi) of all joints can be divided until constant
// loads can just be carried. It is below 1 if they cannot be carried.
#pragma once

#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid::limit {

struct LimitStrength {
  Bearing bearing = Bearing::bears_none;  ///< any: no joint needs shear strength; none: no shear strength is enough
  double factor = 0;
  Twists mechanism;   ///< also if it bears none; empty if it bears any
  bool jams = false;  ///< blocks wedge each other: a little more strength, and forces of any size bear the loads
  double gap = 0;     ///< (power of loads - resistance) over the sum of |load * velocity|
};

LimitStrength limit_strength(const LimitAnalysis& structure, const Wrenches& loads);

}  // namespace blockweir::solid::limit
