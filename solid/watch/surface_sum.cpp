// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/surface_sum.hpp"

#include <utility>

#include "bridge/scene/at.hpp"
#include "solid/watch/joint_lines.hpp"

namespace blockweir::solid {
namespace {

/// Force on the block whose centre lies farther to this side, and the part of it that is normal to the edge.
std::pair<Point, Point> force_on_side(const Solid& solid, const ContactPoint& c, const Point& side) {
  const Placement& edge = solid.placements()[at(c.edge_part)];
  const Point t = edge.vector(c.edge_to - c.edge_from).normalized();
  const Point pushed = c.force.x() * Point(t.y(), -t.x());
  const Point on_vertex = pushed + c.force.y() * t;
  const auto& blocks = solid.placements();
  const Point between = blocks[at(c.vertex_block)].centre() - blocks[at(c.edge_block)].centre();
  return side.dot(between) > 0 ? std::pair(on_vertex, pushed) : std::pair<Point, Point>(-on_vertex, -pushed);
}

}  // namespace

std::vector<SurfaceSum> surface_sums(const Solid& solid, const Surfaces& surfaces) {
  std::vector<SurfaceSum> sums(surfaces.names().size());
  for (const ContactPoint& c : solid.contacts()) {
    // Beside the joint. What lies on it and has never pressed is a crack.
    if (c.state == ContactState::open && !c.has_touched() && !lies_on_joint(solid, c)) continue;
    for (const int surface : surfaces.of(c.pair())) sums[at(surface)].reach(solid.state().place(c));
  }
  const auto is_point = [&](const SurfaceSum& sum) { return sum.length_m() <= 1e-6 * solid.model().size_m; };
  for (const ContactPoint& c : solid.contacts()) {
    for (const int surface : surfaces.of(c.pair())) {
      SurfaceSum& sum = sums[at(surface)];
      if (is_point(sum)) continue;
      if (const JointProperties& law = solid.laws()[c.law]; law.cohesion_pa > 0 || law.tension_pa > 0) {
        sum.add_bond(c.bond * c.bond_length);
      }
      if (c.state == ContactState::open) continue;
      const auto [force, pushed] = force_on_side(solid, c, sum.across());
      const JointProperties& law = solid.laws()[c.law];
      const double kept = law.keeps_cohesion ? c.bond : 0;
      const Strength residual = law.strength(kept, c.bond_length, c.length, c.force.x());
      sum.add(solid.laws().strength(c, c.force.x()), residual, force, pushed, solid.state().place(c));
    }
  }
  return sums;
}

}  // namespace blockweir::solid
