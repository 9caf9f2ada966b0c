// SPDX-License-Identifier: GPL-3.0-or-later
// Water over the crest between two pools that stand above it at different levels: its surface falls in a straight line
// from one pool to the other.
#pragma once

#include <vector>

#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {

/// A straight surface of water, level before its first and beyond its last point.
struct Surface {
  Point from_m = Point::Zero();
  Point to_m = Point::Zero();

  static Surface level(double level_m) { return {{0, level_m}, {0, level_m}}; }
  [[nodiscard]] double at(double x) const;
};

/// From the crest's upstream corner at the one level to its downstream corner at the other.
Surface over_the_crest(const Structure& structure, double upstream_m, double downstream_m);

/// What of `all` is in none of `parts`. Intervals of each list are apart.
std::vector<WetInterval> without(const std::vector<WetInterval>& all,
                                 const std::vector<const std::vector<WetInterval>*>& parts);

}  // namespace blockweir::hydrostatic
