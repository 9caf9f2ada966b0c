// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/expect/point_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"

namespace blockweir::solid::expect {
namespace {

using scene::Scene;

template <int Axis>
double displacement(const Solid& solid, std::size_t block, const Point& point) {
  const Anchor anchor = solid.parts().anchor(static_cast<int>(block), point);
  const auto part = static_cast<std::size_t>(anchor.part);
  // Like an increment from the outline: free of the cancellation of two places.
  const Placement outline(solid.blocks()[part].centroid, Vector6::Zero());
  return outline.increment(solid.states()[part].displacement, anchor.material)[Axis];
}

template <int Component>
double stress(const Solid& solid, std::size_t block, const Point& point) {
  return StressField(solid, block).stress_at(point)[Component];
}

/// Of a beam along x that is held at its left end, with forces at its points.
struct Cantilever {
  double length = 0;
  double depth = 0;
  double middle_y = 0;
  double modulus = 0;  ///< Pa, of a strip in the scene's plane
  double shear_modulus = 0;
  double held_x = 0;
  double inertia() const { return std::pow(depth, 3) / 12; }
};

Cantilever cantilever(const Scene& s, const scene::Block& block) {
  const auto by = [&](auto less) { return std::minmax_element(block.vertices.begin(), block.vertices.end(), less); };
  const auto [left, right] = by([](const Point& p, const Point& q) { return p.x() < q.x(); });
  const auto [low, high] = by([](const Point& p, const Point& q) { return p.y() < q.y(); });
  const scene::Material& m = s.materials[static_cast<std::size_t>(block.material)];
  const double nu = m.poissons_ratio;
  return {.length = right->x() - left->x(),
          .depth = high->y() - low->y(),
          .middle_y = (high->y() + low->y()) / 2,
          .modulus = m.youngs_modulus_pa / (s.analysis.plane == scene::Plane::strain ? 1 - nu * nu : 1),
          .shear_modulus = m.youngs_modulus_pa / (2 * (1 + nu)),
          .held_x = left->x()};
}

/// Sum over the block's point loads of value(arm, force): the arm is that of the load from the held end [m].
template <class Value>
double over_loads(const Scene& s, const scene::Block& block, const Cantilever& beam, Value value) {
  double sum = 0;
  for (const scene::PointLoad& load : s.point_loads) {
    if (&s.blocks[static_cast<std::size_t>(load.block)] != &block) continue;
    sum += value(load.point_m.x() - beam.held_x, load.force_y_n_per_m.at(0));
  }
  return sum;
}

/// F a^2 (3 x - a)/(6 E I) + F a/(k G A) beyond a load at a, k = 5/6 (Timoshenko).
double cantilever_deflection(const Scene& s, const scene::Block& block, const Point& point) {
  const Cantilever beam = cantilever(s, block);
  const double x = point.x() - beam.held_x;
  return over_loads(s, block, beam, [&](double a, double force) {
    const double near = std::min(a, x);
    const double far = std::max(a, x);
    return force * near * near * (3 * far - near) / (6 * beam.modulus * beam.inertia()) +
           force * near / (5.0 / 6 * beam.shear_modulus * beam.depth);
  });
}

/// -M y/I.
double cantilever_stress(const Scene& s, const scene::Block& block, const Point& point) {
  const Cantilever beam = cantilever(s, block);
  const double x = point.x() - beam.held_x;
  const double moment =
      over_loads(s, block, beam, [&](double a, double force) { return force * std::max(0.0, a - x); });
  return -moment * (point.y() - beam.middle_y) / beam.inertia();
}

/// The part of an outline above height y.
std::vector<Point> above(const std::vector<Point>& outline, double y) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    if (a.y() >= y) kept.push_back(a);
    if ((a.y() - y) * (b.y() - y) < 0) kept.emplace_back(a + (b - a) * (y - a.y()) / (b.y() - a.y()));
  }
  return kept;
}

/// Gravity method: vertical stress N/A + M x/I on a horizontal section of a convex block, from the weight above it and
/// the pressures given on faces above it.
double gravity_method_stress(const Scene& s, const scene::Block& block, const Point& point) {
  const double y = point.y();
  const std::vector<Point> upper = above(block.vertices, y);
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  for (const Point& p : upper) {
    if (p.y() > y + 1e-9 * geometry::bounds_of(block.vertices).size()) continue;
    left = std::min(left, p.x());
    right = std::max(right, p.x());
  }
  const double width = right - left;
  const Point middle((left + right) / 2, y);
  const double weight = geometry::signed_area(upper) *
                        s.materials[static_cast<std::size_t>(block.material)].density_kg_per_m3 *
                        s.analysis.gravity_m_per_s2;
  double down = weight;
  double turning = weight * (geometry::centroid(upper).x() - middle.x());  // clockwise
  for (const scene::FacePressure& face : s.face_pressures) {
    if (&s.blocks[static_cast<std::size_t>(face.block)] != &block) continue;
    Point from = face.from_m;
    Point to = face.to_m;
    double p_from = face.pressure_from_pa.at(0);
    double p_to = face.pressure_to_pa.at(0);
    if (from.y() < to.y()) std::swap(from, to), std::swap(p_from, p_to);
    if (from.y() <= y) continue;
    const double share = to.y() >= y ? 1 : (from.y() - y) / (from.y() - to.y());
    to = from + share * (to - from);
    p_to = p_from + share * (p_to - p_from);
    const Point span = to - from;
    const Point centre = geometry::centroid(block.vertices);
    Point inward(-span.y(), span.x());
    if (inward.dot(centre - from) < 0) inward = -inward;
    for (const auto& [place, force] :
         {std::pair(from, (2 * p_from + p_to) / 6), std::pair(to, (p_from + 2 * p_to) / 6)}) {
      const Point push = force * inward;
      const Point arm = place - middle;
      down -= push.y();
      turning -= arm.x() * push.y() - arm.y() * push.x();
    }
  }
  return -down / width - 12 * turning * (point.x() - middle.x()) / std::pow(width, 3);
}

}  // namespace

const std::map<std::string, PointQuantity>& point_quantities() {
  static const std::map<std::string, PointQuantity> all = {{"point_displacement_x_m", displacement<0>},
                                                           {"point_displacement_y_m", displacement<1>},
                                                           {"point_stress_xx_pa", stress<0>},
                                                           {"point_stress_yy_pa", stress<1>},
                                                           {"point_stress_xy_pa", stress<2>}};
  return all;
}

const std::map<std::string, PointFormula>& point_formulas() {
  static const std::map<std::string, PointFormula> all = {{"cantilever-deflection", cantilever_deflection},
                                                          {"cantilever-stress", cantilever_stress},
                                                          {"gravity-method-stress", gravity_method_stress}};
  return all;
}

}  // namespace blockweir::solid::expect
