// SPDX-License-Identifier: GPL-3.0-or-later
// A force and the motion that it resists, as interior point methods have them: both positive, one goes to zero.
#pragma once

#include <algorithm>

namespace blockweir::solid {

struct ComplementaryPair {
  double force = 1;
  double motion = 1;
  double force_change = 0;
  double motion_change = 0;
  double product_change = 0;  ///< nonlinear part of the product that a correction aims at

  [[nodiscard]] double stiffness() const { return force / motion; }
  /// What the motion lacks of the product.
  [[nodiscard]] double lacks(double product) const { return (product - product_change) / force - motion; }
  /// The fraction of its changes, at most all, that uses `within` of the distance to zero.
  [[nodiscard]] double positive_fraction(double within) const {
    const double of_force = force_change < 0 ? -within * force / force_change : 1;
    const double of_motion = motion_change < 0 ? -within * motion / motion_change : 1;
    return std::min({1.0, of_force, of_motion});
  }
  /// The product after that fraction of the changes.
  [[nodiscard]] double product_after(double fraction) const {
    return (force + fraction * force_change) * (motion + fraction * motion_change);
  }
};

}  // namespace blockweir::solid
