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
    return std::min(force_fraction(within), motion_fraction(within));
  }
  [[nodiscard]] double force_fraction(double within) const { return fraction(force, force_change, within); }
  [[nodiscard]] double motion_fraction(double within) const { return fraction(motion, motion_change, within); }
  /// The product after that fraction of the changes.
  [[nodiscard]] double product_after(double fraction) const { return product_after(fraction, fraction); }
  [[nodiscard]] double product_after(double of_force, double of_motion) const {
    return (force + of_force * force_change) * (motion + of_motion * motion_change);
  }

 private:
  static double fraction(double of, double change, double within) {
    return change < 0 ? std::min(1.0, -within * of / change) : 1;
  }
};

}  // namespace blockweir::solid
