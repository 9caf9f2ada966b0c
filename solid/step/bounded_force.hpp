// SPDX-License-Identifier: GPL-3.0-or-later
// The force of one contact by its distances from all bounds of Mohr-Coulomb's law, and how it moves towards the
// analytic centre of what is admissible: where the product of the distances is largest.
#pragma once

#include <Eigen/Core>

#include "solid/contact/force_rule.hpp"

namespace blockweir::solid {

class BoundedForce {
 public:
  /// Of an open contact: none.
  BoundedForce() = default;
  /// The given force, or one near it that is at least so far within the bounds [N per metre].
  BoundedForce(const ForceRule& rule, const Eigen::Vector2d& force, double least);

  /// Does the rule bound forces so that this class can hold them?
  [[nodiscard]] static bool fits(const ForceRule& rule);

  [[nodiscard]] bool open() const { return open_; }
  [[nodiscard]] Eigen::Vector2d force() const;
  /// The inverse of the Hessian of the distances' logarithms, negative [N^2].
  [[nodiscard]] Eigen::Matrix2d squares() const;
  /// The change towards the centre of this contact alone [N per metre].
  [[nodiscard]] Eigen::Vector2d to_centre() const;

  /// Sets the change that a motion (gap, slip) [1/N] has as the multiplier of the balance: to_centre - squares motion.
  void set_motion(const Eigen::Vector2d& motion);
  /// The largest part of a distance that the change takes.
  [[nodiscard]] double lost() const;
  void change(double fraction);
  /// By how much the motion closes the contact, slip opening it by the tangent of friction [1/N].
  [[nodiscard]] double closes() const;
  /// The most that admissible forces can resist a motion that does not.
  [[nodiscard]] double resists() const;

 private:
  /// From the negative and the positive bound of shear, halved; from that of tension. Without cohesion: forces along
  /// both edges of the cone.
  using Distances = Eigen::Array3d;

  bool open_ = true;
  bool bonded_ = false;
  double friction_ = 0;
  double cohesion_ = 0;
  double tension_ = 0;
  Distances distance_ = Distances::Zero();
  Distances change_ = Distances::Zero();
  Eigen::Vector2d motion_ = Eigen::Vector2d::Zero();
};

}  // namespace blockweir::solid
