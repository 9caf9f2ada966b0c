// SPDX-License-Identifier: GPL-3.0-or-later
// Mohr-Coulomb law of a joint at one contact: its strength as it weakens, how slip opens it, and from trial forces to
// admissible ones. The same law as a scene states it: bridge/scene/joint_law.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bridge/scene/joint_law.hpp"

namespace blockweir::solid {

enum class ContactState : int { open = 0, stick = 1, slip = 2 };

/// Present strength of a contact near a normal force [N per metre], with friction as a tangent.
struct Strength {
  double friction = 0;   ///< tan(phi), or of friction that bends its tangent
  double cohesion = 0;   ///< c times bonded length
  double tension = 0;    ///< T times bonded length
  double intercept = 0;  ///< of that tangent

  [[nodiscard]] double shear_of_friction(double normal) const { return normal * friction + intercept; }
  [[nodiscard]] double shear_bound(double normal) const { return std::max(0.0, cohesion + shear_of_friction(normal)); }
  /// Does a bond carry what would be lost at once if it opened?
  [[nodiscard]] bool holds_together() const { return cohesion > 0 || tension > 0; }
  /// A contact that has no tension lets go at zero.
  [[nodiscard]] bool opens(double normal) const { return normal < -tension || (normal <= 0 && tension == 0); }
};

/// A joint law with angles as tangents.
struct JointProperties {
  double friction;
  double residual_friction;
  double cohesion_pa;
  double tension_pa;
  double bonded_length_m;  ///< of the whole joint; negative: all of it
  bool keeps_cohesion;
  double softening_slip_m;  ///< path of slip over which a bond fades; 0: it is brittle
  double dilation;          ///< opening per slip
  double dilation_limit_m;  ///< slip beyond which it opens no further
  int joint;                ///< index into Scene::joints, -1 for the default
  scene::CurvedFriction curve;

  JointProperties(const scene::JointLaw& law, int of_joint)
      : friction(tangent(law.friction_angle_deg)),
        residual_friction(tangent(law.residual_friction_angle_deg)),
        cohesion_pa(law.cohesion_pa),
        tension_pa(law.tension_cut_off_pa()),
        bonded_length_m(law.bonded_length_m.value_or(-1)),
        keeps_cohesion(law.keeps_cohesion),
        softening_slip_m(law.softening_slip_m),
        dilation(tangent(law.dilation_angle_deg)),
        dilation_limit_m(law.dilation_limit_m.value_or(std::numeric_limits<double>::infinity())),
        joint(of_joint),
        curve(law) {}

  /// Has it a bond that can be lost? Whether it is depends on the states on the way to an equilibrium.
  [[nodiscard]] bool bonds() const { return cohesion_pa > 0 || tension_pa > 0 || friction != residual_friction; }
  /// Does slip wear the bond down, rather than break it?
  [[nodiscard]] bool softens() const { return softening_slip_m > 0; }
  [[nodiscard]] bool dilates() const { return dilation > 0; }
  /// Is its friction the same at any normal force?
  [[nodiscard]] bool is_straight() const { return !curve.bends(); }
  /// Near a normal force, for a contact that represents this length of joint and has the share `bond` of its bond left.
  [[nodiscard]] Strength strength(double bond, double bonded_m, double length_m, double normal) const {
    Strength found{.friction = residual_friction + bond * (friction - residual_friction),
                   .cohesion = bond * cohesion_pa * bonded_m,
                   .tension = bond * tension_pa * bonded_m};
    if (is_straight()) return found;
    const double pressure_pa = length_m > 0 ? std::max(0.0, normal) / length_m : 0;
    const scene::StrengthLine line = curve.tangent(found.friction, pressure_pa);
    found.friction = line.friction;
    found.intercept = line.cohesion_pa * length_m;
    return found;
  }
  /// What is left of a softening bond after so long a path of slip.
  [[nodiscard]] double bond_after(double slip_path_m) const {
    if (keeps_cohesion || !softens()) return 1;
    return std::max(0.0, 1 - slip_path_m / softening_slip_m);
  }
  /// Gap that a joint has when its faces ride on each other's roughness after so much slip: a saw tooth of this law's
  /// slope.
  [[nodiscard]] double dilation_m(double slip_m) const {
    return dilation * std::min(std::abs(slip_m), dilation_limit_m);
  }
  /// -d dilation_m / d slip; at zero slip in the given direction.
  [[nodiscard]] double dilation_slope(double slip_m, double direction) const {
    if (std::abs(slip_m) >= dilation_limit_m) return 0;
    return -dilation * std::copysign(1.0, slip_m != 0 ? slip_m : direction);
  }
  /// By how much more slip opens a joint, without cancellation.
  [[nodiscard]] double opens_by(double slip_m, double further_m) const {
    const double after_m = slip_m + further_m;
    const bool one_way = slip_m * after_m > 0 && std::max(std::abs(slip_m), std::abs(after_m)) <= dilation_limit_m;
    if (one_way) return dilation * std::copysign(1.0, slip_m) * further_m;
    return dilation_m(after_m) - dilation_m(slip_m);
  }

  /// For a block that comes onto the joint's plane later: it was never bonded, and belongs to no joint.
  [[nodiscard]] JointProperties of_plane() const {
    JointProperties plane = *this;
    plane.joint = -1;
    plane.friction = residual_friction;
    plane.cohesion_pa = plane.tension_pa = 0;
    plane.bonded_length_m = -1;
    return plane;
  }
  /// Do two laws without bonds slide alike?
  [[nodiscard]] bool slides_as(const JointProperties& other) const {
    return friction == other.friction && dilation == other.dilation && dilation_limit_m == other.dilation_limit_m &&
           curve == other.curve;
  }

 private:
  static double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }
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
inline JointForce acting(ContactState state, const Strength& strength, double normal, double shear) {
  if (state == ContactState::open) return {};
  if (state == ContactState::stick) return {state, normal, shear, 0};
  const double slope = std::copysign(strength.friction, shear);
  return {state, normal, slope * normal + std::copysign(strength.intercept, shear), slope};
}

/// The same with a bound of shear that does not depend on the normal force and acts on an open contact, too (Tresca's
/// friction): the derivative of a convex function of gap and slip where there is no tension.
inline JointForce admissible(const Strength& strength, double bound, double normal, double shear) {
  const bool open = strength.opens(normal);
  const ContactState closed = std::abs(shear) <= bound ? ContactState::stick : ContactState::slip;
  return {open ? ContactState::open : closed, open ? 0 : normal, std::clamp(shear, -bound, bound), 0};
}

}  // namespace blockweir::solid
