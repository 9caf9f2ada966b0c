// SPDX-License-Identifier: GPL-3.0-or-later
// Sliding distance of a block on a horizontal joint by the balance of forces, independent of the contact model.
#include <cmath>
#include <numbers>

#include "solid/expect/formula_tables.hpp"
#include "solid/expect/quantity_tables.hpp"

namespace blockweir::solid::expect {
namespace {

/// Position and velocity of a point mass under a force F and dry friction R.
struct Slider {
  double x = 0;
  double v = 0;

  void advance(double force, double friction, double mass, double dt) {
    if (v == 0 && std::abs(force) <= friction) return;
    const double direction = v != 0 ? std::copysign(1.0, v) : std::copysign(1.0, force);
    const double a = (force - direction * friction) / mass;
    const double stops_after = a * direction < 0 ? -v / a : dt;
    const double t = std::min(dt, stops_after);
    x += v * t + a * t * t / 2;
    v = stops_after < dt ? 0 : v + a * t;
  }
};

}  // namespace

/// The block's way over that which the water's force F in every window gives it by m a = F_x - tan(phi) (W - F_y).
double slip_over_balance(const Outcome& o, const std::string& subject) {
  const scene::Scene& scene = o.solid.scene();
  const std::size_t b = block_index(o.solid, subject);
  const double friction = std::tan(joint_named(scene, subject).law.friction_angle_deg * std::numbers::pi / 180);
  const double mass = o.solid.blocks()[b].mass_per_m();
  const Course& course = o.series.of(b);
  Slider slider;
  for (std::size_t i = 1; i < course.size(); ++i) {
    const Point& water = course[i].water_force;
    const double normal = std::max(0.0, mass * scene.analysis.gravity_m_per_s2 - water.y());
    slider.advance(water.x(), friction * normal, mass, course[i].time_s - course[i - 1].time_s);
  }
  if (slider.x == 0) throw NoFigure("no slip: by the balance of forces the block stays where it is");
  return (course.back().displacement[0] - course.front().displacement[0]) / slider.x;
}

}  // namespace blockweir::solid::expect
