// SPDX-License-Identifier: GPL-3.0-or-later
// Limit equilibrium of blocks on a crack under water, and the water's pressures.
#include <cmath>
#include <functional>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/hydrostatics.hpp"
#include "solid/expect/formula_tables.hpp"

namespace blockweir::solid::expect {
namespace {

using scene::unit_weight_of_water;

/// k: mean pressure in the joint over that at its mouth.
double mean_uplift(const PlaneJoint& p) {
  return scene::named(p.law->uplift).share.value();  // the reader has refused laws without one
}

/// T - N tan(phi) - c L at head z: H = rho g z^2/2, U = k rho g z L, N = W cos a - H sin a - U, T = H cos a + W sin a.
double excess_shear(const Scene& s, const PlaneJoint& p, double head) {
  const double push = unit_weight_of_water(s) * head * head / 2;
  const double lift = mean_uplift(p) * unit_weight_of_water(s) * head * p.length;
  const double normal = p.weight * std::cos(p.dip) - push * std::sin(p.dip) - lift;
  return push * std::cos(p.dip) + p.weight * std::sin(p.dip) - normal * p.friction - p.cohesion;
}

double rising_root(const std::function<double(double)>& f) {
  double low = 0;
  double high = 1;
  while (f(high) < 0 && high < 1e6) high *= 2;
  for (int i = 0; i < 200; ++i) (f((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return (low + high) / 2;
}

double plane_crack_sliding(const Scene& s, const std::string& subject) {
  const PlaneJoint p = plane_joint(s, subject);
  return rising_root([&](double z) { return excess_shear(s, p, z); });
}

double plane_crack_acceleration(const Scene& s, const std::string& subject) {
  const PlaneJoint p = plane_joint(s, subject);
  const double head = s.water.upstream_level_m->at(0) - p.mouth.y();
  return excess_shear(s, p, head) / (p.weight / s.analysis.gravity_m_per_s2);
}

/// Vertical force and moment about the toe (overturning positive) of pressures given on the block's faces.
Eigen::Vector2d given_uplift(const Scene& s, const scene::Block& block, double toe_x) {
  Eigen::Vector2d sum(0, 0);
  for (const auto& load : s.face_pressures) {
    if (&s.blocks[static_cast<std::size_t>(load.block)] != &block) continue;
    const double width = std::abs(load.to_m.x() - load.from_m.x());
    const double pf = load.pressure_from_pa.at(0);
    const double pt = load.pressure_to_pa.at(0);
    sum[0] += (pf + pt) / 2 * width;
    sum[1] += width / 6 * ((2 * pf + pt) * (toe_x - load.from_m.x()) + (pf + 2 * pt) * (toe_x - load.to_m.x()));
  }
  return sum;
}

double monolith_sliding(const Scene& s, const std::string& subject) {
  const PlaneJoint p = plane_joint(s, subject);
  const double lift = given_uplift(s, *p.upper, 0)[0];
  return rising_root([&](double head) { return excess_shear(s, p, head) + lift * p.friction; });
}

double monolith_overturning(const Scene& s, const std::string& subject) {
  const PlaneJoint p = plane_joint(s, subject);
  double toe = -1e300;
  for (const Point& v : p.upper->vertices) toe = std::max(toe, v.x());
  const double moment_of_lift = given_uplift(s, *p.upper, toe)[1];
  const double arm = toe - geometry::centroid(p.upper->vertices).x();
  return std::cbrt(6 * (p.weight * arm - moment_of_lift) / unit_weight_of_water(s));
}

/// Head at which a crack with the reservoir's pressure in it runs through a level joint under an upright face:
/// W d = rho g h^3/6 + rho g h B^2/2, d the weight's way to the toe and B the joint's length.
double cracked_through(const Scene& s, const std::string& subject) {
  const PlaneJoint p = plane_joint(s, subject);
  const double arm = p.mouth.x() + p.length - geometry::centroid(p.upper->vertices).x();
  return rising_root([&](double head) {
    return unit_weight_of_water(s) * head * (head * head / 6 + p.length * p.length / 2) - p.weight * arm;
  });
}

/// Depth of water at the wall's foot, y = 0.
double depth(const Scene& s) {
  return s.water.upstream_level_m->at(s.analysis.duration_s);
}

double hydrostatic_force(const Scene& s, const std::string&) {
  return unit_weight_of_water(s) * depth(s) * depth(s) / 2;
}

/// About the origin at the wall's foot; with the lumped rule in N elements under water it is (1 - 1/N^2) of that.
double hydrostatic_moment(const Scene& s, const std::string& subject) {
  const double exact = unit_weight_of_water(s) * std::pow(depth(s), 3) / 6;
  if (s.water.nodal_rule == scene::NodalRule::consistent) return -exact;
  const double n = s.water.elements_per_face * depth(s) / height(block_named(s, subject));
  return -exact * (1 - 1 / (n * n));
}

/// P0 + rho g z at the mouth of a joint.
double mouth_pressure(const Scene& s, const std::string& subject) {
  const double level = s.water.upstream_level_m->at(s.analysis.duration_s);
  return scene::on_wet_faces(s, level).pressure(plane_joint(s, subject).mouth.y());
}

}  // namespace

const Formulas& dam_formulas() {
  static const Formulas all = {
      {"plane-crack-sliding", plane_crack_sliding}, {"plane-crack-acceleration", plane_crack_acceleration},
      {"monolith-sliding", monolith_sliding},       {"monolith-overturning", monolith_overturning},
      {"cracked-through", cracked_through},         {"hydrostatic-force", hydrostatic_force},
      {"hydrostatic-moment", hydrostatic_moment},   {"mouth-pressure", mouth_pressure}};
  return all;
}

}  // namespace blockweir::solid::expect
