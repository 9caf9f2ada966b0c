// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/failure_mode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/geometry/point.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

/// Half the diagonal of the box around the blocks [m].
double radius(const Solid& solid, const std::vector<int>& blocks) {
  Eigen::AlignedBox2d box;
  for (const int b : blocks) {
    for (const Point& X : solid.blocks()[at(b)].vertices) box.extend(solid.placements()[at(b)].position(X));
  }
  return box.diagonal().norm() / 2;
}

/// Contacts between the body and the rest; 1 if the vertex is the body's, -1 if the edge is.
template <class Look>
void each_left(const Solid& solid, const MovingBody& body, Look look) {
  for (const ContactPoint& c : solid.contacts()) {
    for (const auto& [inside, outside] : body.left) {
      if (c.vertex_block == inside && c.edge_block == outside) look(c, 1);
      if (c.edge_block == inside && c.vertex_block == outside) look(c, -1);
    }
  }
}

/// Out of the joint, into the body.
Point way_out(const Solid& solid, const ContactPoint& c, int of_body) {
  const Placement& edge = solid.placements()[at(c.edge_part)];
  return -of_body * perpendicular(edge.vector(c.edge_to - c.edge_from)).normalized();
}

/// At the present positions: the contact's own gap is that at the start of the last step, and a static analysis takes
/// few, long steps.
double gap_now(const Solid& solid, const ContactPoint& c) {
  const Placement& edge = solid.placements()[at(c.edge_part)];
  const Point from_edge = solid.placements()[at(c.vertex_part)].position(c.vertex_at) - edge.position(c.edge_from);
  return -perpendicular(edge.vector(c.edge_to - c.edge_from)).normalized().dot(from_edge);
}

/// Do all contacts at which the body had stood open, each by more than any slips?
bool leaves_straight(const MovedSince& moved, const MovingBody& body) {
  constexpr double touched = 0.1;  // of what has opened: the gap before
  bool any = false;
  bool any_closed = false;
  double least = std::numeric_limits<double>::infinity();
  double slip = 0;
  each_left(moved.solid(), body, [&](const ContactPoint& c, int of_body) {
    const Point away = way_out(moved.solid(), c, of_body);
    const Point apart = of_body * moved.apart(c);
    const double opening = away.dot(apart);
    any_closed = any_closed || c.state != ContactState::open;
    slip = std::max(slip, std::abs(geometry::cross(away, apart)));
    if (gap_now(moved.solid(), c) - opening > touched * opening) return;
    any = true;
    least = std::min(least, opening);
  });
  return any && !any_closed && least > slip;
}

/// Whether the body opens a joint behind it by rotating about its pressed edge. Strain and oscillation may rotate it,
/// but open no joint; a body that slides away from a wall opens that joint by its slip.
bool opens_by_turning(const MovedSince& moved, const MovingBody& body, const PairMotions& pairs, double turn) {
  constexpr double opened = 0.2;  // of the turn times the joint's length, however slender the body
  const Solid& solid = moved.solid();
  double pressed = 0;
  Point place = Point::Zero();  // where the body presses, and its slip there, weighted by how much
  Point slip = Point::Zero();
  each_left(solid, body, [&](const ContactPoint& c, int of_body) {
    if (c.state == ContactState::open) return;
    pressed += c.force.x();
    place += c.force.x() * solid.state().place(c);
    slip += c.force.x() * of_body * moved.apart(c);
  });
  if (pressed <= 0) return true;
  place /= pressed;
  slip /= pressed;
  Eigen::AlignedBox2d joint;
  for (const auto& [inside, outside] : body.left) joint.extend(pairs.at(std::minmax(inside, outside)).points);
  const double least = opened * std::abs(turn) * joint.diagonal().norm();
  bool opens = false;
  each_left(solid, body, [&](const ContactPoint& c, int of_body) {
    const Point away = way_out(solid, c, of_body);
    const double beyond_slip = away.dot(of_body * moved.apart(c)) - std::max(0.0, away.dot(slip));
    const double by_turning = turn * away.dot(perpendicular(solid.state().place(c) - place));
    opens = opens || std::min({gap_now(solid, c), beyond_slip, by_turning}) >= least;
  });
  return opens;
}

}  // namespace

Mode mode_of(const MovedSince& moved, const MovingBody& body, const PairMotions& pairs) {
  // Shares of the way: a body that turns about its toe has about 1/2 of it from the turning, one that slides none.
  constexpr double turns = 0.02;
  constexpr double slides = 0.002;
  double travel = 0;
  double mass = 0;
  double turned = 0;
  Point way = Point::Zero();
  for (const int b : body.blocks) {
    const double m = moved.solid().blocks()[at(b)].mass_per_m();
    travel = std::max(travel, moved.farthest(b));
    mass += m;
    turned += m * moved.turned(b);
    way += m * moved(b, Point::Zero());
  }
  const double turn = turned / mass;
  double slip = 0;
  for (const auto& [inside, outside] : body.left) slip = std::max(slip, pairs.at(std::minmax(inside, outside)).slip);
  const double by_turn = std::abs(turn) * radius(moved.solid(), body.blocks);
  // What slides faster than its head follows leans back: it falls over no edge.
  const bool leans_back = turn * way.x() > 0 && slip > by_turn;
  const bool turning = by_turn > turns * travel && !leans_back;
  const Point gravity = moved.solid().scene().analysis.gravity();
  const bool sliding = slip > slides * travel;
  // A body that topples from a single corner opens no joint.
  return {.turns = turning && (!sliding || opens_by_turning(moved, body, pairs, turn)),
          .slides = sliding,
          .leaves = !turning && leaves_straight(moved, body),
          .up = gravity.isZero(0) ? way.y() > 0 : way.dot(gravity) < 0};
}

}  // namespace blockweir::solid
