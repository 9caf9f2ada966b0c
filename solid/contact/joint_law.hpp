// SPDX-License-Identifier: GPL-3.0-or-later
// Mohr-Coulomb law of a joint at one contact: from trial forces to admissible ones.
#pragma once

#include <algorithm>
#include <cmath>

namespace blockweir::solid {

enum class ContactState : int { open = 0, stick = 1, slip = 2 };

/// Strength of a contact as it stands now [N per metre], friction as a tangent.
struct Strength {
  double friction = 0;  ///< tan(phi)
  double cohesion = 0;  ///< c times bonded length
  double tension = 0;   ///< T times bonded length

  [[nodiscard]] double shear_bound(double normal) const { return std::max(0.0, cohesion + normal * friction); }
  /// Does a bond carry what would be lost at once if it opened?
  [[nodiscard]] bool holds_together() const { return cohesion > 0 || tension > 0; }
  /// A contact that has no tension lets go at zero.
  [[nodiscard]] bool opens(double normal) const { return normal < -tension || (normal <= 0 && tension == 0); }
};

/// Forces on the vertex along the normal (compression positive) and along the edge.
struct JointForce {
  ContactState state = ContactState::open;
  double normal = 0;
  double shear = 0;
  double shear_per_normal = 0;  ///< d shear / d normal while slipping
};

/// |shear| <= cohesion + normal * friction, normal >= -tension; beyond the first the contact slips at the bound
/// of the current normal force, beyond the second it opens.
inline JointForce admissible(const Strength& strength, double normal, double shear) {
  if (strength.opens(normal)) return {};
  const double bound = strength.shear_bound(normal);
  if (std::abs(shear) <= bound) return {ContactState::stick, normal, shear, 0};
  const double side = std::copysign(1.0, shear);
  return {ContactState::slip, normal, side * bound, bound > 0 ? side * strength.friction : 0};
}

/// What acts in a state that is known, whether it is admissible or not: without cohesion and tension, slip on the side
/// to which `shear` points.
inline JointForce acting(ContactState state, double friction, double normal, double shear) {
  if (state == ContactState::open) return {};
  if (state == ContactState::stick) return {state, normal, shear, 0};
  const double slope = std::copysign(friction, shear);
  return {state, normal, slope * normal, slope};
}

/// The same with a bound of shear that does not depend on the normal force and acts on an open contact, too (Tresca's
/// friction): the derivative of a convex function of gap and slip where there is no tension.
inline JointForce admissible(const Strength& strength, double bound, double normal, double shear) {
  const bool open = strength.opens(normal);
  const ContactState closed = std::abs(shear) <= bound ? ContactState::stick : ContactState::slip;
  return {open ? ContactState::open : closed, open ? 0 : normal, std::clamp(shear, -bound, bound), 0};
}

}  // namespace blockweir::solid
