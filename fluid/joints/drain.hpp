// SPDX-License-Identifier: GPL-3.0-or-later
// The law of a line of drains that crosses a joint. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <algorithm>
#include <cmath>

#include "bridge/scene/drain.hpp"

namespace blockweir::joints {

/// Head [m, on the y axis] that is left at the drain of efficiency E: h_0 + (1 - E) (h - h_0), h the head there without
/// it, h_0 what it drains to, if stated, else the lower head of both ends of the joint. A drain raises no head.
inline double head_at_drain(const scene::Drain& drain, double undrained_m, double lower_end_m) {
  const double drains_to = std::isnan(drain.head_m) ? lower_end_m : drain.head_m;
  const double left = std::max(0.0, undrained_m - drains_to) * (1 - drain.efficiency);
  return std::min(undrained_m, drains_to + left);
}

}  // namespace blockweir::joints
