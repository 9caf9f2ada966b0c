// SPDX-License-Identifier: GPL-3.0-or-later
// Water above the crest between two pools with different levels. Up to the lower level the water presses everywhere.
// The pressure of the water above that, which flows, follows [water] crest_pressure, as with the reservoir alone above
// the crest. The load is therefore continuous when the lower pool reaches the crest, and when both levels become
// equal.
#pragma once

#include <vector>

#include "bridge/scene/water.hpp"
#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {

/// A piecewise straight water surface, level before its first and after its last point.
struct Surface {
  Point from_m = Point::Zero();
  Point to_m = Point::Zero();

  static Surface level(double level_m) { return {{0, level_m}, {0, level_m}}; }
  [[nodiscard]] double at(double x) const;
};

/// none: the lower level. triangular: from the reservoir's level above the crest's upstream corner to the lower level
/// above its downstream corner. full: the reservoir's level. If the tailwater is higher, the lower level in all cases:
/// the law applies to the reservoir.
Surface over_the_crest(const Structure& structure, double upstream_m, double downstream_m, scene::CrestPressure law);

/// The parts of `all` that are in none of `parts`. Intervals of each list must not overlap.
std::vector<WetInterval> without(const std::vector<WetInterval>& all,
                                 const std::vector<const std::vector<WetInterval>*>& parts);

}  // namespace blockweir::hydrostatic
