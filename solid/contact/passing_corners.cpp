// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/passing_corners.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::solid {

void PassingCorners::begin_search() {
  passed_.swap(passing_);
  passing_.clear();
}

bool PassingCorners::passed_before(const ContactPoint& c) const {
  return std::any_of(passed_.begin(), passed_.end(), [&](const ContactPoint& p) { return p.pair() == c.pair(); });
}

double PassingCorners::nearness(const ContactPoint& c) const {
  const auto entered = std::find_if(entered_.begin(), entered_.end(), [&](const auto& e) { return e.same_key(c); });
  return entered == entered_.end() ? c.gap : entered->gap;
}

bool PassingCorners::did_enter(const ContactPoint& c) const {
  return std::any_of(entered_.begin(), entered_.end(), [&](const ContactPoint& e) { return e.same_key(c); });
}

/// Has a vertex of one block entered another, by this edge? Not while it touches an edge that it may press on.
bool PassingCorners::within(const std::vector<Point>& vertices, std::size_t v, const std::vector<Point>& edges,
                            std::size_t edge) const {
  const Point& p = vertices[v];
  bool touches = false;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Point span = edges[next(e, edges.size())] - edges[e];
    const double s = std::clamp(span.dot(p - edges[e]) / span.squaredNorm(), 0.0, 1.0);
    const double distance = (edges[e] + s * span - p).norm();
    if (distance > outlines_.give_m()) continue;
    if (faces(vertices, v, Point(span.y(), -span.x()).normalized(), closing)) return false;
    touches = touches || distance <= outlines_.coincidence_m();
  }
  return touches || encloses(edges, p) || pierces(vertices, v, edges, edge, outlines_.coincidence_m());
}

/// Where the block is now, in `corners`.
const std::vector<Point>& PassingCorners::outline(const std::vector<Placement>& placements, int block,
                                                  std::vector<Point>& corners) const {
  const MovingParts& parts = outlines_.parts();
  corners.clear();
  for (const ContactSide& side : parts.contact_outlines[at(block)]) {
    corners.push_back(placements[at(side.part)].position(side.from));
  }
  return corners;
}

void PassingCorners::end_search() {
  passing_of_.clear();
  for (std::size_t i = 0; i < passing_.size(); ++i) {
    for (const int b : {passing_[i].vertex_block, passing_[i].edge_block})
      passing_of_.emplace_back(b, static_cast<int>(i));
  }
  std::sort(passing_of_.begin(), passing_of_.end());
}

bool PassingCorners::entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                             double left_m) {
  bool any = false;
  for (const ContactPoint& c : passing_) any = note_entered(placements, contacts, left_m, c) || any;
  return any;
}

bool PassingCorners::entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                             double left_m, const std::vector<int>& island) {
  bool any = false;
  for (const ContactPoint* c : of(island)) any = note_entered(placements, contacts, left_m, *c) || any;
  return any;
}

std::vector<const ContactPoint*> PassingCorners::of(const std::vector<int>& island) const {
  std::vector<const ContactPoint*> all;
  for (const int b : island) {
    auto of_b = std::lower_bound(passing_of_.begin(), passing_of_.end(), std::pair(b, 0));
    for (; of_b != passing_of_.end() && of_b->first == b; ++of_b) {
      const ContactPoint& c = passing_[at(of_b->second)];
      const int other = c.vertex_block == b ? c.edge_block : c.vertex_block;
      const bool seen_with_other = other < b && std::binary_search(island.begin(), island.end(), other);
      if (!seen_with_other) all.push_back(&c);
    }
  }
  return all;
}

bool PassingCorners::note_entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                                  double left_m, const ContactPoint& c) {
  if (c.gap < -outlines_.give_m()) return false;  // behind the edge's line all along
  const auto& vertices = outline(placements, c.vertex_block, moved_[0]);
  const auto& edges = outline(placements, c.edge_block, moved_[1]);
  if (!within(vertices, at(c.vertex), edges, at(c.edge))) return false;
  const bool presses_already = std::any_of(contacts.begin(), contacts.end(), [&](const ContactPoint& other) {
    return other.state != ContactState::open && other.vertex_block == c.vertex_block && other.vertex == c.vertex &&
           other.edge_block == c.edge_block;
  });
  if (presses_already) return false;
  // A vertex that has gone through an edge and out again beside its end has that end in one of its sides. Where the two
  // are a contact, that holds what the step at hand has not closed yet. What was in before, as corners of blocks that
  // strain may be, is none of that: a face turned on its far end, and its near end sank in.
  const bool was_in = c.gap < -2 * outlines_.coincidence_m();
  const std::size_t to = next(at(c.edge), edges.size());
  const Point span = edges[to] - edges[at(c.edge)];
  const Point way = vertices[at(c.vertex)] - edges[at(c.edge)];
  const std::size_t end = span.dot(way) > span.squaredNorm() / 2 ? to : at(c.edge);
  const auto side_holds_end = [&](const ContactPoint& other) {
    return other.vertex_block == c.edge_block && other.edge_block == c.vertex_block && at(other.vertex) == end &&
           (other.edge == c.vertex || at(c.vertex) == next(at(other.edge), vertices.size()));
  };
  const bool through = !encloses(edges, vertices[at(c.vertex)]) &&
                       pierces(vertices, at(c.vertex), edges, at(c.edge), outlines_.coincidence_m());
  if (through && !was_in && std::any_of(contacts.begin(), contacts.end(), side_holds_end)) return false;
  const double gap = cross(way, span.normalized());
  if (left_m > 0 && gap >= -left_m) return false;
  entered_.push_back(c);
  entered_.back().gap = gap;
  return true;
}

bool PassingCorners::presses_too(const ContactPoint& c) const {
  return std::any_of(turned_on_.begin(), turned_on_.end(), [&](const ContactPoint& t) { return t.same_key(c); });
}

bool PassingCorners::turned_on(const std::vector<Placement>& placements, double left_m) {
  const std::size_t before = turned_on_.size();
  for (const ContactPoint& c : stood_for_) {
    if (presses_too(c)) continue;
    const Point vertex = outline(placements, c.vertex_block, moved_[0])[at(c.vertex)];
    const auto& edges = outline(placements, c.edge_block, moved_[1]);
    const Point& from = edges[at(c.edge)];
    const double gap = cross(vertex - from, (edges[next(at(c.edge), edges.size())] - from).normalized());
    if (gap < -std::max(left_m, outlines_.give_m()) && encloses(edges, vertex)) turned_on_.push_back(c);
  }
  return turned_on_.size() > before;
}

bool PassingCorners::did_miss(const ContactPoint& c) const {
  return std::any_of(missed_.begin(), missed_.end(), [&](const ContactPoint& m) { return m.same_key(c); });
}

/// Not where the other block goes on beyond the end. When the vertex is there follows from what was expected: the force
/// that it should not have had has slowed it down.
bool PassingCorners::note_missed(const ContactPoint& c, double opened_m, const Point& expected, double slip_m,
                                 double least_m) {
  if (expected.x() <= least_m || did_enter(c)) return false;
  const auto& edges = outlines_.of(c.edge_block);
  const std::size_t to = next(at(c.edge), edges.size());
  const Point span = edges[to] - edges[at(c.edge)];
  const double to_end = std::max(0.0, (slip_m > 0 ? 1 - c.anchor : c.anchor) * span.norm());
  if (to_end >= std::abs(slip_m)) return false;
  const std::size_t end = slip_m > 0 ? to : at(c.edge);
  const Point in = (edges[end] - edges[previous(end, edges.size())]).normalized();
  const Point out = (edges[next(end, edges.size())] - edges[end]).normalized();
  if (cross(in, out) <= parallel_tolerance) return false;
  const double share = to_end / std::max(to_end, slip_m > 0 ? expected.y() : -expected.y());
  const double gap_at_end = c.gap - opened_m - (to_end > 0 ? share * expected.x() : 0);
  if (gap_at_end < -least_m) return false;
  missed_.push_back(c);
  return true;
}

}  // namespace blockweir::solid
