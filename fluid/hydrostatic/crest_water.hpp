// SPDX-License-Identifier: GPL-3.0-or-later
// Water over the crest between two pools that stand above it at different levels. What stands there up to the lower
// level presses all along; of what flows over that the scene's [water] crest_pressure states the pressure, as it does
// where the reservoir alone is above the crest. So the load jumps neither as the lower pool reaches the crest nor as
// both levels become equal.
#pragma once

#include <vector>

#include "bridge/scene/water.hpp"
#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {

/// A straight surface of water, level before its first and beyond its last point.
struct Surface {
  Point from_m = Point::Zero();
  Point to_m = Point::Zero();

  static Surface level(double level_m) { return {{0, level_m}, {0, level_m}}; }
  [[nodiscard]] double at(double x) const;
};

/// None: at the lower level. Triangular: from the reservoir's, above the crest's upstream corner, to the other, above
/// its downstream corner. Full: at the reservoir's. At the lower level for any law where the tailwater is the higher
/// one: the law is the reservoir's.
Surface over_the_crest(const Structure& structure, double upstream_m, double downstream_m, scene::CrestPressure law);

/// What of `all` is in none of `parts`. Intervals of each list are apart.
std::vector<WetInterval> without(const std::vector<WetInterval>& all,
                                 const std::vector<const std::vector<WetInterval>*>& parts);

}  // namespace blockweir::hydrostatic
