// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of a line of drains that crosses a joint. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <algorithm>
#include <cmath>

#include "bridge/scene/drain.hpp"

namespace blockweir::joints {

/// Head [m, an elevation y] at a drain of efficiency E: h_0 + (1 - E) (h - h_0). h is the head there without the drain,
/// h_0 the stated head in the drain or else the lower head of the joint's ends. A drain does not raise a head.
inline double head_at_drain(const scene::Drain& drain, double undrained_m, double lower_end_m) {
  const double drains_to = std::isnan(drain.head_m) ? lower_end_m : drain.head_m;
  const double left = std::max(0.0, undrained_m - drains_to) * (1 - drain.efficiency);
  return std::min(undrained_m, drains_to + left);
}

}  // namespace blockweir::joints
