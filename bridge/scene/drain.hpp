// SPDX-License-Identifier: GPL-3.0-or-later
// A line of drains, as a scene states it. C++17: the OpenFOAM plugin includes this. Equations: fluid/joints/drain.hpp.
#pragma once

#include <cmath>
#include <limits>

namespace blockweir::scene {

/// A line of drains that crosses a joint.
struct Drain {
  double station_m = 0;  ///< from the joint's upstream end
  /// Share 0..1 by which the drain lowers the head of the undrained joint towards head_m.
  double efficiency = 1;
  /// Head in the drain, as an elevation y; NaN: the lower of the heads at the joint's two ends.
  double head_m = std::numeric_limits<double>::quiet_NaN();
};

inline bool operator==(const Drain& a, const Drain& b) {
  const bool same_head = a.head_m == b.head_m || (std::isnan(a.head_m) && std::isnan(b.head_m));
  return a.station_m == b.station_m && a.efficiency == b.efficiency && same_head;
}

}  // namespace blockweir::scene
