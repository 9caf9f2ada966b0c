// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks on the move.
#include <cmath>

#include "solid/output/formula_parts.hpp"

namespace blockweir::solid::output {
namespace {

/// s = g (sin a - cos a tan phi) t^2/2 for the joint's dip.
double incline_displacement(const Scene& s, const std::string& of) {
  const PlaneJoint p = plane_joint(s, of);
  const double t = s.analysis.duration_s;
  return s.analysis.gravity_m_per_s2 * (std::sin(p.dip) - std::cos(p.dip) * p.friction) * t * t / 2;
}

/// A rigid block on the joint's plane while the base moves: g (1 + a_y/g) and -a_x act along and across it, and it
/// slides, down or up, while friction cannot hold it. Midpoint rule in a million steps.
double shaken_incline_displacement(const Scene& s, const std::string& of) {
  constexpr int steps = 1'000'000;
  const PlaneJoint p = plane_joint(s, of);
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
                               {"shaken-incline-displacement", shaken_incline_displacement}};
  return all;
}

}  // namespace blockweir::solid::output
