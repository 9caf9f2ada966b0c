// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks on the move.
#include <cmath>
#include <numbers>

#include "bridge/geometry/polygon.hpp"
#include "solid/expect/formula_tables.hpp"

namespace blockweir::solid::expect {
namespace {

/// s = g (sin a - cos a tan phi) t^2/2 for the joint's dip.
double incline_displacement(const Scene& s, const std::string& subject) {
  const PlaneJoint p = plane_joint(s, subject);
  const double t = s.analysis.duration_s;
  return s.analysis.gravity_m_per_s2 * (std::sin(p.dip) - std::cos(p.dip) * p.friction) * t * t / 2;
}

/// s = (F - N tan phi)/m t^2/2: blocks pushed as one over level ground by constant forces at points, F along it,
/// against the friction of the joints that have no law of their own; N is their weight, less what the forces lift.
double pushed_displacement(const Scene& s, const std::string&) {
  double mass = 0;
  for (const scene::Block& b : s.blocks) {
    if (!b.fixed) mass += geometry::signed_area(b.vertices) * material_of(s, b).density_kg_per_m3;
  }
  double push = 0;
  double normal = mass * s.analysis.gravity_m_per_s2;
  for (const scene::PointLoad& load : s.point_loads) {
    push += load.force_x_n_per_m.at(0);
    normal -= load.force_y_n_per_m.at(0);
  }
  const double friction = std::tan(s.default_joint.friction_angle_deg * std::numbers::pi / 180);
  const double t = s.analysis.duration_s;
  return (push - normal * friction) / mass * t * t / 2;
}

/// A rigid block on the joint's plane while the base moves: g (1 + a_y/g) and -a_x act along and across it, and it
/// slides, down or up, while friction cannot hold it. Midpoint rule in a million steps.
double shaken_incline_displacement(const Scene& s, const std::string& subject) {
  constexpr int steps = 1'000'000;
  const PlaneJoint p = plane_joint(s, subject);
  const scene::BaseMotion base = s.base_motion.value_or(scene::BaseMotion{});
  const double dt = s.analysis.duration_s / steps;
  double speed = 0;  // downwards
  double slid = 0;
  for (int n = 0; n < steps; ++n) {
    const double t = (n + 0.5) * dt;
    const double down = s.analysis.gravity_m_per_s2 + base.acceleration_y_m_per_s2.at(t);
    const double aside = -base.acceleration_x_m_per_s2.at(t);
    const double drive = down * std::sin(p.dip) + aside * std::cos(p.dip);
    const double hold = std::max(0.0, down * std::cos(p.dip) - aside * std::sin(p.dip)) * p.friction;
    const double before = speed;
    if (before == 0 && std::abs(drive) <= hold) continue;
    speed += dt * (drive - std::copysign(hold, before == 0 ? drive : before));
    if (before * speed < 0) speed = 0;  // friction stops, it does not drive
    slid += dt * (before + speed) / 2;
  }
  return std::abs(slid);
}

}  // namespace

const Formulas& motion_formulas() {
  static const Formulas all = {{"incline-displacement", incline_displacement},
                               {"pushed-displacement", pushed_displacement},
                               {"shaken-incline-displacement", shaken_incline_displacement}};
  return all;
}

}  // namespace blockweir::solid::expect
