// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/trial.hpp"

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

/// What rests does so exactly.
Point moved(const Trial& trial, std::size_t b, const Point& X) {
  const Vector6& increment = trial.increment[b];
  return increment.isZero(0) ? Point(Point::Zero()) : trial.start[b].increment(increment, trial.turn[b], X);
}

/// What moves a point, whether it cancels there or not: a slender block's base hardly moves while the block turns.
double motion(const Vector6& increment, const Point& X) {
  return increment.head<2>().norm() + increment.tail<4>().norm() * X.norm();
}

}  // namespace

EdgeFrame edge_frame(const Trial& trial, const ContactPoint& c) {
  const Point span = trial.placement[at(c.edge_part)].vector(c.edge_to - c.edge_from);
  const double length = span.norm();
  const Point t = span / length;
  return {t, Point(t.y(), -t.x()), length};
}

Point edge_point(const ContactPoint& c, double fraction) {
  return c.edge_from + fraction * (c.edge_to - c.edge_from);
}

Interaction interaction_of(const ContactPoint& c, const EdgeFrame& edge, double slip) {
  return {.block_i = c.vertex_part,
          .block_j = c.edge_part,
          .at_i = c.vertex_at,
          .at_j = edge_point(c, c.anchor + slip / edge.length),
          .axis = edge.n};
}

Interaction interaction_of(const Support& s) {
  return {.block_i = s.block, .at_i = s.material};
}

Separation separation_of(const Trial& trial, const ContactPoint& c, const EdgeFrame& edge) {
  const auto v = at(c.vertex_part);
  const auto e = at(c.edge_part);
  const Point vertex_moved = moved(trial, v, c.vertex_at);
  const Point foot = edge_point(c, c.anchor);
  const Point edge_moved = moved(trial, e, foot);
  const Point apart = c.separation + vertex_moved - edge_moved;
  return {{edge.n.dot(apart), edge.t.dot(apart)},
          motion(trial.increment[v], c.vertex_at) + motion(trial.increment[e], foot)};
}

Separation separation_of(const Trial& trial, const Support& s) {
  const auto b = at(s.block);
  const Point moved = trial.start[b].increment(trial.increment[b], trial.turn[b], s.material);
  return {s.held().cwiseProduct(s.separation + moved), motion(trial.increment[b], s.material)};
}

}  // namespace blockweir::solid
