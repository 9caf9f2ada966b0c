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
  if (normal < -strength.tension || (normal <= 0 && strength.tension == 0)) return {};
  const double bound = std::max(0.0, strength.cohesion + normal * strength.friction);
  if (std::abs(shear) <= bound) return {ContactState::stick, normal, shear, 0};
  const double side = std::copysign(1.0, shear);
  return {ContactState::slip, normal, side * bound, bound > 0 ? side * strength.friction : 0};
}

}  // namespace blockweir::solid
