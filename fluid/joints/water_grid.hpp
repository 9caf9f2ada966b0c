// SPDX-License-Identifier: GPL-3.0-or-later
// Converts metres to Clipper's integers and back, and defines the lengths that count as zero. All are fractions of the
// section's size, so that a laboratory model and a mountain give the same results.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <polyclipping/clipper.hpp>

#include "fluid/joints/polygon_offset.hpp"

namespace blockweir::joints {

using Extent = Eigen::AlignedBox2d;

struct Grid {
  Point origin_m;
  double per_m;
  double unit_m;  ///< 2^-50 of the size or a little more: Clipper's products are off by one unit at most
  double tiny_m;  ///< shorter than anything that matters, longer than round-off

  explicit Grid(const Extent& reach) {
    const int power = std::ilogb(reach.sizes().maxCoeff());
    const double step_m = std::ldexp(1.0, power + 2);  // near the origin there is no offset: round numbers stay exact
    for (const int i : {0, 1}) origin_m[i] = step_m * std::nearbyint(reach.center()[i] / step_m);
    per_m = std::ldexp(1.0, 50 - power);
    unit_m = 1 / per_m;
    const double farthest_m = std::max(reach.min().cwiseAbs().maxCoeff(), reach.max().cwiseAbs().maxCoeff());
    tiny_m = 4096 * unit_m + 16 * std::numeric_limits<double>::epsilon() * farthest_m;
  }

  [[nodiscard]] ClipperLib::IntPoint units(const Point& p) const {
    const auto whole = [&](double metres) { return static_cast<ClipperLib::cInt>(std::llround(metres * per_m)); };
    return {whole(p.x() - origin_m.x()), whole(p.y() - origin_m.y())};
  }
  [[nodiscard]] Point metres(const ClipperLib::IntPoint& p) const {
    return {origin_m.x() + static_cast<double>(p.X) * unit_m, origin_m.y() + static_cast<double>(p.Y) * unit_m};
  }
  [[nodiscard]] ClipperLib::Path units(const Ring& ring) const {
    ClipperLib::Path path;
    path.reserve(ring.size());
    for (const Point& p : ring) path.push_back(units(p));
    return path;
  }
  /// Removes the rounding by growing, Clipper and moving back: corners at round numbers are exact again.
  [[nodiscard]] Point rounded(const Point& p) const {
    const double coarse_m = 32 * unit_m;
    return {coarse_m * std::nearbyint(p.x() / coarse_m), coarse_m * std::nearbyint(p.y() / coarse_m)};
  }
};

}  // namespace blockweir::joints
