// SPDX-License-Identifier: GPL-3.0-or-later
// The force of one contact by its distances from all bounds of Mohr-Coulomb's law, each paired with the motion that
// resists it, as primal-dual interior point methods have them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "solid/contact/complementary_pair.hpp"
#include "solid/contact/force_rule.hpp"

namespace blockweir::solid {

class BoundedForce {
 public:
  /// Of an open contact: none.
  BoundedForce() = default;
  /// The given force, or one near it that is at least so far within the bounds [N per metre]. Products of distances
  /// and motions are one.
  BoundedForce(const ForceRule& rule, const Eigen::Vector2d& force, double least);

  /// Does the rule bound forces so that this class can hold them?
  [[nodiscard]] static bool fits(const ForceRule& rule);

  [[nodiscard]] bool open() const { return count_ == 0; }
  [[nodiscard]] Eigen::Vector2d force() const;
  /// Change of the force by which a motion of the contact is resisted. Where all products are one: the inverse of the
  /// Hessian of the sum of the distances' logarithms, negative [N^2].
  [[nodiscard]] Eigen::Matrix2d stiffness() const;
  /// The force's change if nothing moves, as products aim at this, less what they are to leave out [N per metre].
  [[nodiscard]] Eigen::Vector2d change_at_rest(double product) const;
  /// Sets the changes that go with a motion (gap, slip) [1/N] of the contact.
  void set_changes(double product, const Eigen::Vector2d& motion);
  /// By how much the motion closes the contact, slip opening it by the tangent of friction [1/N].
  [[nodiscard]] double closes() const;
  /// The most that admissible forces can resist a motion that does not.
  [[nodiscard]] double resists() const;

  /// From the negative and the positive bound of shear, halved; from that of tension. Without cohesion: forces along
  /// both edges of the cone.
  [[nodiscard]] std::span<ComplementaryPair> distances() { return {distances_.data(), count_}; }
  [[nodiscard]] std::span<const ComplementaryPair> distances() const { return {distances_.data(), count_}; }

 private:
  [[nodiscard]] bool bonded() const { return count_ == 3; }

  std::size_t count_ = 0;
  double friction_ = 0;
  double cohesion_ = 0;
  double tension_ = 0;
  std::array<ComplementaryPair, 3> distances_;
  Eigen::Vector2d motion_ = Eigen::Vector2d::Zero();
};

}  // namespace blockweir::solid
