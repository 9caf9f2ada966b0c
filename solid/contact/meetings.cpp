// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that meet: of all pairs of vertex and edge that describe one contact, the search keeps one.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "bridge/scene/at.hpp"
#include "solid/contact/outline.hpp"
#include "solid/contact/search.hpp"

namespace blockweir::solid {

/// A vertex that touches one edge of a block near a corner lies far behind the next one, which it has never met: only
/// closed contacts, and of the others the least penetrated, may press from within, where it is within. One that lies
/// beside a block's acute corner is behind the line of an edge there, and in nothing.
void ContactSearch::drop_edges_seen_from_within() {
  const auto same_vertex = [](const ContactPoint& a, const ContactPoint& b) {
    return a.vertex_block == b.vertex_block && a.vertex == b.vertex && a.edge_block == b.edge_block;
  };
  std::size_t kept = 0;
  for (std::size_t first = 0, end = 0; first < found_.size(); first = end) {  // edges that one vertex meets
    double best = found_[first].gap;
    for (end = first; end < found_.size() && same_vertex(found_[first], found_[end]); ++end) {
      best = std::max(best, found_[end].gap);
    }
    for (std::size_t i = first; i < end; ++i) {
      const ContactPoint& c = found_[i];
      if (c.state == ContactState::open && c.gap < -coincidence_ && (c.gap < best || !overlaps_at(c))) continue;
      inherited_[kept] = inherited_[i];
      found_[kept++] = found_[i];
    }
  }
  found_.resize(kept);
  inherited_.resize(kept);
}

/// Is the vertex in the edge's block, or through the edge and out of that again?
bool ContactSearch::overlaps_at(const ContactPoint& c) const {
  const auto& vertices = corners_[at(c.vertex_block)];
  const auto& edges = corners_[at(c.edge_block)];
  return encloses(edges, vertex_of(c)) || pierces(vertices, at(c.vertex), edges, at(c.edge), coincidence_);
}

const Point& ContactSearch::vertex_of(const ContactPoint& c) const {
  return corners_[static_cast<std::size_t>(c.vertex_block)][static_cast<std::size_t>(c.vertex)];
}

std::pair<Point, Point> ContactSearch::edge_of(const ContactPoint& c) const {
  const auto& E = corners_[static_cast<std::size_t>(c.edge_block)];
  const auto e = static_cast<std::size_t>(c.edge);
  return {E[e], E[next(e, E.size())]};
}

/// The vertex of the edge's block that the contact's vertex lies at, or -1.
int ContactSearch::met_vertex(const ContactPoint& c) const {
  const auto& E = corners_[static_cast<std::size_t>(c.edge_block)];
  const auto convex = [&](std::size_t w) {  // or straight: a node on a face
    const Point in = (E[w] - E[previous(w, E.size())]).normalized();
    return cross(in, (E[next(w, E.size())] - E[w]).normalized()) > -parallel_tolerance;
  };
  const auto e = static_cast<std::size_t>(c.edge);
  const double opened = opening(c);
  Point vertex = vertex_of(c);
  if (opened > 0) {
    const Point t = (E[next(e, E.size())] - E[e]).normalized();
    vertex -= opened * Point(t.y(), -t.x());
  }
  for (const std::size_t w : {e, next(e, E.size())}) {
    if ((E[w] - vertex).norm() < std::max(2 * coincidence_, 2 * std::abs(c.gap - opened)) && convex(w)) {
      return static_cast<int>(w);
    }
  }
  return -1;
}

/// Can two corners pass each other: is the vertex on the outer side of the edge that goes on from this one at a corner?
/// Then it is in the block of neither, and may leave along both.
bool ContactSearch::may_pass(const ContactPoint& c) const {
  const auto& E = corners_[static_cast<std::size_t>(c.edge_block)];
  const auto e = static_cast<std::size_t>(c.edge);
  const auto goes_on = [&](std::size_t edge, std::size_t corner) {
    const Point t = (E[next(edge, E.size())] - E[edge]).normalized();
    const Point in = (E[corner] - E[previous(corner, E.size())]).normalized();
    const Point out = (E[next(corner, E.size())] - E[corner]).normalized();
    return cross(in, out) > parallel_tolerance && cross(vertex_of(c) - E[edge], t) >= -give_;
  };
  return goes_on(previous(e, E.size()), e) || goes_on(next(e, E.size()), next(e, E.size()));
}

/// Do the vertices of two mirrored contacts bound what two faces have in common, or will have once these have turned
/// onto each other? Then they are two contacts, its ends, however far the faces still are from each other.
bool ContactSearch::bound_overlap(const ContactPoint& a, const ContactPoint& b) const {
  const auto along = [this](const ContactPoint& c) { return Point(edge_of(c).second - edge_of(c).first).normalized(); };
  const auto over_its_edge = [&](const ContactPoint& c) {
    const auto [from, to] = edge_of(c);
    return std::min(along(c).dot(vertex_of(c) - from), along(c).dot(to - vertex_of(c))) > 2 * coincidence_;
  };
  return over_its_edge(a) && over_its_edge(b) && along(a).dot(along(b)) < -std::cos(parallel_tolerance + closing);
}

/// Corners that have passed each other a little behind the line of their faces go on as they are: pushed onto it at
/// once, they would fly.
void ContactSearch::count_from_passing() {
  const auto between_the_same = [](const ContactPoint& a, const ContactPoint& b) { return a.pair() == b.pair(); };
  for (std::size_t i = 0; i < found_.size() && !passed_.empty(); ++i) {
    ContactPoint& c = found_[i];
    if (inherited_[i] != 0 || c.gap >= -coincidence_ || c.gap <= -give_) continue;
    if (std::any_of(passed_.begin(), passed_.end(), [&](const auto& p) { return between_the_same(p, c); })) {
      c.gap_at_start = c.gap;
      count_from_start(c);
    }
  }
}

/// Is the vertex's block on the outer side of the edge, but for what blocks strain?
bool ContactSearch::faces_outside(const ContactPoint& c) const {
  constexpr double strained = 1e-3;  // rad
  const auto [from, to] = edge_of(c);
  const Point t = (to - from).normalized();
  return faces(corners_[at(c.vertex_block)], at(c.vertex), Point(t.y(), -t.x()), strained);
}

/// How near a contact is to being the one of its meeting: of corners that a step has taken into each other that edge is
/// the entrance which the step has left least behind.
double ContactSearch::nearness(const ContactPoint& c) const {
  const auto entered = std::find_if(entered_.begin(), entered_.end(), [&](const auto& e) { return e.same_key(c); });
  return entered == entered_.end() ? c.gap : entered->gap;
}

/// Where two convex vertices meet, up to four vertex-edge candidates describe one contact. What the meeting has come to
/// know stays with the one that is kept.
void ContactSearch::keep_one_of_each_meeting() {
  std::vector<std::size_t> kept_for(found_.size());  // by each: itself, or what it was dropped for
  for (std::size_t i = 0; i < kept_for.size(); ++i) kept_for[i] = i;
  std::vector<std::size_t> mirrored_out;
  const auto drop_for = [&](std::size_t dropped, std::size_t kept) {
    kept_for[dropped] = kept;
    if (inherited_[dropped] == 0 || inherited_[kept] != 0 || found_[dropped].state == ContactState::open) return;
    static_cast<ContactMemory&>(found_[kept]) = found_[dropped];
    inherited_[kept] = 1;
    count_from_start(found_[kept]);
  };
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const int wi = kept_for[i] != i ? -1 : met_vertex(found_[i]);
    if (wi < 0) continue;
    for (std::size_t j = i + 1; j < found_.size() && found_[j].pair() == found_[i].pair(); ++j) {
      ContactPoint& a = found_[i];
      ContactPoint& b = found_[j];
      if (kept_for[j] != j) continue;
      const bool same = b.vertex_block == a.vertex_block && b.vertex == a.vertex && b.edge_block == a.edge_block;
      const bool mirrored = b.vertex_block == a.edge_block && b.vertex == wi && b.edge_block == a.vertex_block;
      if (!(same || mirrored) || met_vertex(b) < 0) continue;
      if (mirrored && (met_vertex(b) != a.vertex || bound_overlap(a, b) || presses_too(a) || presses_too(b))) continue;
      // What the vertex's block is wholly on the outer side of outranks the far side of a thin block; faces that lie on
      // each other a mere meeting of corners; then memory; then the entrance edge.
      const auto rank = [&](std::size_t k) {
        const ContactPoint& c = found_[k];
        return std::make_tuple(faces_outside(c), c.length > 2 * coincidence_,
                               inherited_[k] != 0 && c.state != ContactState::open, did_enter(c), nearness(c));
      };
      const bool second = rank(j) > rank(i);
      if (same) a.length = b.length = a.length + b.length;  // two edges of one face, which go on from each other
      if (mirrored) mirrored_out.push_back(second ? i : j);
      if (second) {
        drop_for(i, j);
        break;
      }
      drop_for(j, i);
    }
  }
  let_pass(kept_for);
  stood_for_.clear();
  for (const std::size_t i : mirrored_out) {
    if (kept_for[i] < found_.size() && found_[i].gap >= -coincidence_) stood_for_.push_back(found_[i]);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    if (kept_for[i] == i) found_[kept++] = found_[i];
  }
  found_.resize(kept);
}

/// Corners that touch in a point, as those of bricks that slide over others, press only once one has entered. By which
/// edge is seen then. Faces that share no more than blocks give way by catch on each other no longer than that.
void ContactSearch::let_pass(std::vector<std::size_t>& kept_for) {
  const auto kept = [&](std::size_t i) {
    while (kept_for[i] != i) i = kept_for[i];
    return i;
  };
  std::vector<char> passes(found_.size(), 0);
  for (std::size_t i = 0; i < found_.size(); ++i) passes[i] = kept_for[i] == i && passes_alone(found_[i]);
  for (std::size_t i = 0; i < found_.size(); ++i) {
    if (did_enter(found_[i])) passes[kept(i)] = 0;
  }
  std::vector<std::size_t> let;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    if (passes[kept(i)] != 0) passing_.push_back(found_[i]), let.push_back(i);
  }
  for (const std::size_t i : let) kept_for[i] = found_.size();
}

/// By itself, whatever else describes its meeting. Faces askew to the way that they pass along lie over each other by
/// their distance times a cotangent. Behind the edge counts from the edge itself: steps would add up.
bool ContactSearch::passes_alone(const ContactPoint& c) const {
  constexpr double steepest = 10;
  const bool open = c.state == ContactState::open && c.length <= std::max(give_, steepest * c.gap);
  const bool catches = c.length > 0 && c.length <= give_;
  return (open || catches) && c.gap + c.gap_at_start > -give_ && may_pass(c);
}

}  // namespace blockweir::solid
