// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/meetings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"
#include "solid/contact/outline.hpp"
#include "solid/contact/outline_overlap.hpp"

namespace blockweir::solid {
namespace {

constexpr double beside_ratio = 2e-7;  // of the scene: a vertex no farther past the end of a face is on it
constexpr double apart = std::numeric_limits<double>::infinity();  // gap of what does not overlap after all

/// Nearest place to `p` on an outline.
Point nearest_on(const std::vector<Point>& outline, const Point& p) {
  Point nearest = outline[0];
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const Point span = outline[next(e, outline.size())] - outline[e];
    const Point foot = outline[e] + std::clamp(span.dot(p - outline[e]) / span.squaredNorm(), 0.0, 1.0) * span;
    if ((foot - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = foot;
  }
  return nearest;
}

}  // namespace

Meeting Meetings::of_contact(const ContactPoint& c) {
  Meeting meeting = of(c, /*at_corner=*/false);
  meeting.gap -= c.gap_at_start + model_.laws[c.law].dilation_m(c.slip_m) + formulation_->gap_under_force_m(c);
  return meeting;
}

Meeting Meetings::of_passing(const ContactPoint& c) {
  Meeting meeting = of(c, /*at_corner=*/true);
  meeting.gap += model_.give_under_weight_m;
  return meeting;
}

/// Of a vertex that has slid past its edge the end of the edge is looked at, too: that may be in the vertex's block.
/// Not where the edge ends in a notch: what is past it is in the wall, which a corner that takes up more than half of
/// the plane does not show.
Meeting Meetings::of(const ContactPoint& c, bool at_corner) {
  const EdgeFrame edge = edge_frame(trial_.at_start(), c);
  const Point from = state_.placements[at(c.edge_part)].position(c.edge_from);
  const Point vertex = state_.place(c);
  const double s = edge.t.dot(vertex - from);
  const bool beside = std::max(-s, s - edge.length) > beside_ratio * model_.size_m;
  if (beside || at_corner) {
    const Corner end = corner_now(c.edge_block, near_end(c));
    if (!reflex(end.points, 1)) {
      return checked(of_corners(corner_now(c.vertex_block, at(c.vertex)), end), /*on_face=*/false);
    }
  }
  const Meeting meeting{.corner_block = c.vertex_block,
                        .vertex = at(c.vertex),
                        .face_block = c.edge_block,
                        .edge = at(c.edge),
                        .corner = vertex,
                        .normal = edge.n,
                        .gap = edge.n.dot(vertex - from)};
  return checked(meeting, !beside);
}

/// The vertex of the edge's block that the contact's vertex is nearer to.
std::size_t Meetings::near_end(const ContactPoint& c) const {
  const EdgeFrame edge = edge_frame(trial_.at_start(), c);
  const double s = edge.t.dot(state_.place(c) - state_.placements[at(c.edge_part)].position(c.edge_from));
  return s < edge.length / 2 ? at(c.edge) : next(at(c.edge), model_.parts.contact_outlines[at(c.edge_block)].size());
}

bool Meetings::corners_touch(const ContactPoint& c, double moved_m, double deepest_m) {
  constexpr double near = 1e-4;     // of the scene
  constexpr double of_block = 0.1;  // of the smaller one's radius: its other corners are farther away
  const double radius_m = std::min(model_.blocks[at(c.vertex_part)].radius, model_.blocks[at(c.edge_part)].radius);
  const ContactSide& end = model_.parts.contact_outlines[at(c.edge_block)][near_end(c)];
  const Point corner = state_.placements[at(end.part)].position(end.from);
  const double apart_m = (corner - state_.place(c)).norm();
  if (apart_m < near * model_.size_m) return true;
  return apart_m < std::min(moved_m, of_block * radius_m) && std::abs(of_passing(c).gap) < 2 * deepest_m;
}

/// A corner of a block between its neighbours, as they are now.
Meetings::Corner Meetings::corner_now(int block, std::size_t vertex) const {
  const ContactOutline& outline = model_.parts.contact_outlines[at(block)];
  const std::size_t before = previous(vertex, outline.size());
  Corner corner{block, vertex, {before, vertex}, {}};
  for (const std::size_t v : {before, vertex, next(vertex, outline.size())}) {
    corner.points.push_back(state_.placements[at(outline[v].part)].position(outline[v].from));
  }
  return corner;
}

/// Two corners side by side: of their four faces the one that parts them most. It has the other corner's block on its
/// outer side, if need be but for round-off: through a sharp corner the other may have come out again.
Meeting Meetings::of_corners(const Corner& vertex, const Corner& end) {
  Meeting meeting;
  meeting.gap = -apart;
  int best = -1;
  for (const auto& [of, other] : {std::pair(&vertex, &end), std::pair(&end, &vertex)}) {
    for (const std::size_t side : {0, 1}) {
      const Point t = (of->points[side + 1] - of->points[side]).normalized();
      const Point n(t.y(), -t.x());
      const double gap = n.dot(other->points[1] - of->points[1]);
      const int parts = faces(other->points, 1, n, 0) ? 2 : faces(other->points, 1, n, parallel_tolerance) ? 1 : 0;
      if (parts < best || (parts == best && (gap <= meeting.gap || (parts == 0 && of == &end)))) continue;
      best = parts;
      meeting = {other->block, other->vertex, of->block, of->sides[side], other->points[1], n, gap};
    }
  }
  return meeting;
}

/// A corner behind the line of a face overlaps only where it is in the face's block, or through the face and out again
/// beside its end: then outlines cross. What has come in by another face leaves by the nearest, but not by one that its
/// block is behind while it is in front of this. None is pushed by much more than the outlines are in each other.
Meeting Meetings::checked(Meeting meeting, bool on_face) {
  constexpr double as_deep = 2;
  constexpr double crossed = 4;  // what tips have in common is narrower than they have come past each other
  if (meeting.gap >= -beside_ratio * model_.size_m) return meeting;
  const std::vector<Point>& face_block = outline_now(meeting.face_block, outlines_[0]);
  const bool enclosed = encloses(face_block, meeting.corner);
  if (enclosed && on_face) return meeting;
  const std::vector<Point>& corner_block = outline_now(meeting.corner_block, outlines_[1]);
  const Point out = nearest_on(face_block, meeting.corner) - meeting.corner;
  if (enclosed && -meeting.gap <= as_deep * out.norm()) return meeting;
  const auto in_front = [&](const Point& n) { return faces(corner_block, meeting.vertex, n, parallel_tolerance); };
  if (enclosed && (in_front(out.normalized()) || !in_front(meeting.normal))) {
    meeting.normal = out.normalized();
    meeting.gap = -out.norm();
    return meeting;
  }
  const double deep_m = overlap_m(face_block, corner_block, 0);
  meeting.gap = deep_m == 0 ? apart : std::max(meeting.gap, -crossed * deep_m);
  return meeting;
}

const std::vector<Point>& Meetings::outline_now(int block, std::vector<Point>& corners) const {
  corners.clear();
  for (const ContactSide& side : model_.parts.contact_outlines[at(block)]) {
    corners.push_back(state_.placements[at(side.part)].position(side.from));
  }
  return corners;
}

}  // namespace blockweir::solid
