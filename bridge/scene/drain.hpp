// SPDX-License-Identifier: GPL-3.0-or-later
// A line of drains, as a scene states it. C++17: the OpenFOAM plugin includes this. fluid/joints/drain.hpp has its law.
#pragma once

#include <cmath>
#include <limits>

namespace blockweir::scene {

/// A line of drains that crosses a joint.
struct Drain {
  double station_m = 0;  ///< from the joint's upstream end
  /// By which the drain takes away the head of the undrained joint above the head that it drains to, 0..1.
  double efficiency = 1;
  /// That it drains to, as a height on the y axis; NaN: the lower of both ends' heads.
  double head_m = std::numeric_limits<double>::quiet_NaN();
};

inline bool operator==(const Drain& a, const Drain& b) {
  const bool same_head = a.head_m == b.head_m || (std::isnan(a.head_m) && std::isnan(b.head_m));
  return a.station_m == b.station_m && a.efficiency == b.efficiency && same_head;
}

}  // namespace blockweir::scene
