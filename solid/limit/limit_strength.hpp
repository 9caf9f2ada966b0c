// SPDX-License-Identifier: GPL-3.0-or-later
// Strength reduction by limit analysis: the factor by which c and tan(phi) of all joints can be divided until loads
// that stay as they are can just be borne; below 1 where they cannot be borne.
#pragma once

#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid::limit {

struct LimitStrength {
  Bearing bearing = Bearing::bears_none;  ///< any: no joint needs shear strength; none: no shear strength would do
  double factor = 0;
  Twists mechanism;  ///< of what bears none, too; none where it bears any
  double gap = 0;    ///< power of loads less resistance, over the sum of loads times velocities in size
};

LimitStrength limit_strength(const LimitAnalysis& structure, const Wrenches& loads);

}  // namespace blockweir::solid::limit
