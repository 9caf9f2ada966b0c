// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "solid/contact/outline_overlap.hpp"
#include "solid/contact/trial.hpp"

namespace blockweir::solid {

bool precedes(const ContactPoint& a, const ContactPoint& b) {
  const auto place = [](const ContactPoint& c) { return std::make_tuple(c.pair(), c.vertex_block, c.vertex, c.edge); };
  return place(a) < place(b);
}

bool of_lower_pair(const ContactPoint& a, const ContactPoint& b) {
  return a.pair() < b.pair();
}

namespace {

/// Length over which the edge from `vertex` towards `end` lies on the edge a + s t, 0 <= s <= length; none where it
/// comes off that by more than `off_m`.
double overlap(const Point& vertex, const Point& end, const Point& a, const Point& t, double length, double off_m) {
  const Point direction = (end - vertex).normalized();
  const double turned = std::abs(cross(direction, t));
  if (turned > parallel_tolerance) return 0;
  const double s0 = t.dot(vertex - a);
  const double s1 = t.dot(end - a);
  const double over = std::max(0.0, std::min(std::max(s0, s1), length) - std::max(std::min(s0, s1), 0.0));
  return turned * over > off_m ? 0 : over;
}

/// Is the edge in the face's line, but for a thousandth of the way from one to the other: coordinates are rounded? The
/// edge's centroid is `apart` from the face's.
bool drawn_in_line(const ContactSide& face, const ContactSide& edge, const Point& apart) {
  const Point span = face.to - face.from;
  const auto is_off = [&](const Point& p) {
    const Point way = apart + p - face.from;
    return std::abs(cross(span, way)) > 1e-3 * span.norm() * std::max(span.norm(), way.norm());
  };
  return !is_off(edge.from) && !is_off(edge.to);
}

}  // namespace

ContactSearch::ContactSearch(const MovingParts& parts, const JointLaws& laws, double size_m, double reach_m,
                             double farthest_reach_m)
    : parts_(parts),
      laws_(laws),
      outlines_(parts, size_m),
      pairs_(reach_m, farthest_reach_m, parts.contact_outlines.size()) {
  if (laws.any_plane()) find_planes();
}

void ContactSearch::find_planes() {
  planes_.resize(parts_.contact_outlines.size());
  for (std::size_t b = 0; b < planes_.size(); ++b) {
    for (const ContactSide& side : parts_.contact_outlines[b]) {
      planes_[b].push_back(laws_.plane_of(static_cast<int>(b), side.described_edge, side.s_from, side.s_to));
    }
  }
}

/// Of a vertex on an edge along `t`: of the two faces that the vertex ends, the one that is nearer to lying on the
/// edge.
int ContactSearch::law_on(int vertex_block, std::size_t vertex, int edge_block, std::size_t edge,
                          const Point& t) const {
  if (planes_.empty()) return laws_.between(vertex_block, edge_block);
  const auto& edges = outlines_.edges(vertex_block);
  const std::size_t before = previous(vertex, edges.size());
  const double turned_in = t.dot(edges[before].along);
  const double turned_out = t.dot(edges[vertex].along);
  const std::size_t face = turned_in < turned_out ? before : vertex;
  const ContactSide& at_face = parts_.contact_outlines[at(vertex_block)][face];
  const ContactSide& at_edge = parts_.contact_outlines[at(edge_block)][edge];
  const Point apart = parts_.blocks[at(at_edge.part)].centroid - parts_.blocks[at(at_face.part)].centroid;
  return laws_.of_contact(
      vertex_block, planes_[at(vertex_block)][face],
      {edge_block, at_edge.described_edge, planes_[at(edge_block)][edge], drawn_in_line(at_face, at_edge, apart)});
}

void ContactSearch::update(const std::vector<Placement>& placements, std::vector<ContactPoint>& contacts) {
  openings_.note(contacts);
  pairs_.refresh(placements, outlines_, openings_);
  found_.all.clear();
  passing_.begin_search();
  for (const auto& [a, b] : pairs_.all()) {
    if (!pairs_.box(a).intersects(pairs_.box(b))) continue;
    vertices_on_edges(a, b);
    vertices_on_edges(b, a);
  }
  inherit(placements, contacts);
  CandidateFilter filter(outlines_, openings_, passing_, found_);
  filter.count_from_passing();
  filter.keep_bonds_past_flat_corners();
  filter.drop_edges_seen_from_within();
  filter.keep_one_of_each();
  passing_.end_search();
  contacts.swap(found_.all);
}

double ContactSearch::overlap_m(const std::vector<Placement>& placements, double known_m) {
  for (std::size_t b = 0; b < outlines_.all().size(); ++b) outlines_.move(b, placements);
  double deepest_m = known_m;
  for (const auto& [a, b] : pairs_.all()) {
    deepest_m = parting_shift_m(outlines_.of(a), outlines_.of(b), deepest_m);
  }
  return deepest_m;
}

void ContactSearch::vertices_on_edges(int vertex_block, int edge_block) {
  const auto& V = outlines_.of(vertex_block);
  const auto& E = outlines_.of(edge_block);
  const Box& zone = pairs_.box(edge_block);
  const double opened = openings_.between(vertex_block, edge_block);
  const double off_m = as_drawn_ ? 2 * outlines_.coincidence_m() : std::numeric_limits<double>::infinity();
  // Less deep, a vertex that slipped past an acute corner keeps its contact.
  const double deep = std::max(outlines_.coincidence_m(), 1e-3 * (zone.sizes().minCoeff() - pairs_.reach_m() -
                                                                  2 * openings_.largest_m(at(edge_block))));
  const auto& edges_of_vertex = outlines_.edges(vertex_block);
  const auto& edges = outlines_.edges(edge_block);
  for (std::size_t v = 0; v < V.size(); ++v) {
    if (!zone.contains(V[v])) continue;
    const Point& before = V[previous(v, V.size())];
    const Point& after = V[next(v, V.size())];
    const Point to_before = -edges_of_vertex[previous(v, V.size())].along;
    const Point& to_after = edges_of_vertex[v].along;
    // A reflex vertex cannot enter anything; a node on a face that has bent can.
    if (cross(to_after, to_before) < -parallel_tolerance) continue;
    for (std::size_t e = 0; e < E.size(); ++e) {
      const Point& a = E[e];
      const auto& [t, edge_length] = edges[e];
      const Point n(t.y(), -t.x());
      const double gap = n.dot(V[v] - a);
      const double s = t.dot(V[v] - a);
      const double beyond = std::max(-s, s - edge_length);
      if (std::max({gap - opened, -gap, beyond}) > pairs_.reach_m()) continue;
      if (!faces(to_before, to_after, n, closing, gap > outlines_.coincidence_m() ? closing : 0)) continue;
      // On the block's far side, not in it; a tip that may pass another can be out of that again beside the edge's end.
      const auto has_passed = [&] {
        return gap >= -outlines_.give_m() && pierces(V, v, E, e, outlines_.coincidence_m());
      };
      if (gap < -deep && !encloses(E, V[v]) && !has_passed()) continue;
      ContactPoint contact;
      contact.vertex_block = vertex_block;
      contact.vertex = static_cast<int>(v);
      contact.edge_block = edge_block;
      contact.edge = static_cast<int>(e);
      const ContactSide& at_vertex = parts_.contact_outlines[static_cast<std::size_t>(vertex_block)][v];
      const ContactSide& at_edge = parts_.contact_outlines[static_cast<std::size_t>(edge_block)][e];
      contact.vertex_part = at_vertex.part;
      contact.vertex_at = at_vertex.from;
      contact.edge_part = at_edge.part;
      contact.edge_from = at_edge.from;
      contact.edge_to = at_edge.to;
      contact.law = law_on(vertex_block, v, edge_block, e, t);
      contact.gap = gap;
      contact.anchor = s / edge_length;
      contact.separation = gap * n;
      contact.length =
          (overlap(V[v], before, a, t, edge_length, off_m) + overlap(V[v], after, a, t, edge_length, off_m)) / 2;
      // Two acute corners may meet where neither faces the other's edges; farther from these, they may pass. In a
      // notch nothing passes: the edge goes on in its wall, and what slides on that will meet it.
      const bool in_notch = beyond > 0 && reflex(E, s < 0 ? e : next(e, E.size()));
      const bool near = beyond <= std::max(outlines_.coincidence_m(), (gap - opened) / 2) || in_notch;
      const bool meets = passing_.did_enter(contact) || (near && !passing_.did_miss(contact));
      meets ? found_.all.push_back(contact) : passing_.add(contact);
    }
  }
}

/// Vertex minus anchor point: as the scene's outlines have it, and what displacements have made of it. So at rest it
/// stays the same to the last digit, wherever the blocks stand.
Point ContactSearch::apart(const std::vector<Placement>& placements, const ContactPoint& c) const {
  const auto v = static_cast<std::size_t>(c.vertex_part);
  const auto e = static_cast<std::size_t>(c.edge_part);
  const Point foot = edge_point(c, c.anchor);
  const Point at_first = (parts_.blocks[v].centroid - parts_.blocks[e].centroid) + (c.vertex_at - foot);
  return at_first + (placements[v].displacement(c.vertex_at) - placements[e].displacement(foot));
}

/// The same contact keeps its memory and its slip anchor. Of those that are gone, each hands its force to the
/// nearest new contact between the same two blocks that points the same way: near along all of its face, or at a flat
/// corner it would go on to the face beyond, and leave its own without a bond. Those in touch come first; one that has
/// opened still has the bond and the slip of its joint.
void ContactSearch::inherit(const std::vector<Placement>& placements, std::vector<ContactPoint>& old) {
  const auto take = [](ContactMemory& heir, const ContactMemory& from) { heir = from; };
  found_.inherited.assign(found_.all.size(), 0);
  std::vector<const ContactPoint*> gone;
  std::vector<ContactPoint> parting;
  auto heir = found_.all.begin();
  for (const ContactPoint& was : old) {
    while (heir != found_.all.end() && precedes(*heir, was)) ++heir;
    if (heir == found_.all.end() || !heir->same_key(was)) {
      if (was.state != ContactState::open || was.has_touched()) gone.push_back(&was);
      if (openings_.slips_on(was)) parting.push_back(was);
      continue;
    }
    take(*heir, was);
    if (was.state != ContactState::open) heir->law = was.law;  // what bears keeps it
    found_.inherited[static_cast<std::size_t>(heir - found_.all.begin())] = 1;
    if (was.state == ContactState::open && openings_.slips_on(was)) heir->slip_m = openings_.slip_since(was);
    if (was.state == ContactState::open) continue;
    // In touch: slip goes on from the old anchor, so that what a tolerance lets through does not add up.
    heir->anchor = was.anchor;
    heir->separation = apart(placements, *heir);
  }
  std::stable_partition(gone.begin(), gone.end(), [](const auto* was) { return was->state != ContactState::open; });
  for (const ContactPoint* was : gone) {
    const Point& place = outlines_.vertex_of(*was);
    ContactPoint* nearest = nullptr;
    const double reach_m = pairs_.reach_m() + openings_.of(*was);
    double nearest_m = std::numeric_limits<double>::infinity();
    const auto [first, end] = std::equal_range(found_.all.begin(), found_.all.end(), *was, of_lower_pair);
    for (auto near = first; near != end; ++near) {
      ContactPoint& c = *near;
      if (found_.inherited[static_cast<std::size_t>(near - found_.all.begin())] != 0 ||
          !outlines_.of_one_joint(c, *was))
        continue;
      const double distance_m = (outlines_.vertex_of(c) - place).norm();
      const double along_face_m = distance_m + outlines_.turned(c, *was) * was->length;
      if (distance_m >= reach_m || along_face_m >= nearest_m) continue;
      nearest = &c;
      nearest_m = along_face_m;
    }
    if (nearest == nullptr) continue;
    // Across the joint normal and tangent turn round, and so does the body that the force acts on: all signs stay.
    take(*nearest, *was);
    found_.inherited[static_cast<std::size_t>(nearest - found_.all.data())] = 1;
  }
  openings_.hand_on(parting, found_.all, found_.inherited);
  for (ContactPoint& c : found_.all) outlines_.count_from_start(c);
}

}  // namespace blockweir::solid
