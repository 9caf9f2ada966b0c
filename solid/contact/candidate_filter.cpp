// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/candidate_filter.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace blockweir::solid {

void CandidateFilter::drop_edges_seen_from_within() {
  const auto same_vertex = [](const ContactPoint& a, const ContactPoint& b) {
    return a.vertex_block == b.vertex_block && a.vertex == b.vertex && a.edge_block == b.edge_block;
  };
  std::size_t kept = 0;
  for (std::size_t first = 0, end = 0; first < found_.all.size(); first = end) {  // edges that one vertex meets
    double best = found_.all[first].gap;
    for (end = first; end < found_.all.size() && same_vertex(found_.all[first], found_.all[end]); ++end) {
      best = std::max(best, found_.all[end].gap);
    }
    for (std::size_t i = first; i < end; ++i) {
      const ContactPoint& c = found_.all[i];
      if (c.state == ContactState::open && c.gap < -outlines_.coincidence_m() && (c.gap < best || !overlaps_at(c)))
        continue;
      found_.inherited[kept] = found_.inherited[i];
      if (kept != i) found_.all[kept] = c;
      ++kept;
    }
  }
  found_.all.resize(kept);
  found_.inherited.resize(kept);
}

/// Is the vertex in the edge's block, or through the edge and out of that again?
bool CandidateFilter::overlaps_at(const ContactPoint& c) const {
  const auto& vertices = outlines_.of(c.vertex_block);
  const auto& edges = outlines_.of(c.edge_block);
  return encloses(edges, outlines_.vertex_of(c)) ||
         pierces(vertices, at(c.vertex), edges, at(c.edge), outlines_.coincidence_m());
}

/// The vertex of the edge's block that the contact's vertex lies at, or -1.
int CandidateFilter::met_vertex(const ContactPoint& c) const {
  const auto& E = outlines_.of(c.edge_block);
  const auto& edges = outlines_.edges(c.edge_block);
  const auto convex = [&](std::size_t w) {  // or straight: a node on a face
    return cross(edges[previous(w, E.size())].along, edges[w].along) > -parallel_tolerance;
  };
  const auto e = static_cast<std::size_t>(c.edge);
  const double opened = openings_.of(c);
  Point vertex = outlines_.vertex_of(c);
  if (opened > 0) vertex -= opened * outlines_.normal_of(c);
  for (const std::size_t w : {e, next(e, E.size())}) {
    if ((E[w] - vertex).norm() < std::max(2 * outlines_.coincidence_m(), 2 * std::abs(c.gap - opened)) && convex(w)) {
      return static_cast<int>(w);
    }
  }
  return -1;
}

/// Can two corners pass each other: is the vertex on the outer side of the edge that goes on from this one at a corner?
/// Then it is in the block of neither, and may leave along both.
bool CandidateFilter::may_pass(const ContactPoint& c) const {
  const auto& E = outlines_.of(c.edge_block);
  const auto e = static_cast<std::size_t>(c.edge);
  const auto& edges = outlines_.edges(c.edge_block);
  const auto goes_on = [&](std::size_t edge, std::size_t corner) {
    const double turns = cross(edges[previous(corner, E.size())].along, edges[corner].along);
    return turns > parallel_tolerance &&
           cross(outlines_.vertex_of(c) - E[edge], edges[edge].along) >= -outlines_.give_m();
  };
  return goes_on(previous(e, E.size()), e) || goes_on(next(e, E.size()), next(e, E.size()));
}

/// Do the vertices of two mirrored contacts bound what two faces have in common, or will have once these have turned
/// onto each other? Then they are two contacts, its ends, however far the faces still are from each other.
bool CandidateFilter::bound_overlap(const ContactPoint& a, const ContactPoint& b) const {
  const auto along = [this](const ContactPoint& c) -> const Point& {
    return outlines_.edges(c.edge_block)[at(c.edge)].along;
  };
  const auto over_its_edge = [&](const ContactPoint& c) {
    const auto [from, to] = outlines_.edge_of(c);
    return std::min(along(c).dot(outlines_.vertex_of(c) - from), along(c).dot(to - outlines_.vertex_of(c))) >
           2 * outlines_.coincidence_m();
  };
  return over_its_edge(a) && over_its_edge(b) && along(a).dot(along(b)) < -std::cos(parallel_tolerance + closing);
}

void CandidateFilter::count_from_passing() {
  for (std::size_t i = 0; i < found_.all.size(); ++i) {
    ContactPoint& c = found_.all[i];
    if (found_.inherited[i] != 0 || c.gap >= -outlines_.coincidence_m() || c.gap <= -outlines_.give_m()) continue;
    if (!passing_.passed_before(c)) continue;
    c.gap_at_start = c.gap;
    outlines_.count_from_start(c);
  }
}

void CandidateFilter::keep_bonds_past_flat_corners() {
  if (std::none_of(found_.all.begin(), found_.all.end(), [](const ContactPoint& c) { return c.bonded(); })) return;
  FoundContacts kept;
  for (auto first = found_.all.begin(), end = first; first != found_.all.end(); first = end) {  // of a pair
    while (end != found_.all.end() && end->pair() == first->pair()) ++end;
    for (auto c = first; c != end; ++c) {
      const auto stands_for_it = [&](const ContactPoint& other) {
        return other.bonded() && other.state != ContactState::open && c->gap > -outlines_.coincidence_m() &&
               (past_flat_corner(*c, other) || past_flat_corner(other, *c));
      };
      if (!c->bonded() && std::any_of(first, end, stands_for_it)) continue;
      kept.all.push_back(*c);
      kept.inherited.push_back(found_.inherited[static_cast<std::size_t>(c - found_.all.begin())]);
    }
  }
  found_.all.swap(kept.all);
  found_.inherited.swap(kept.inherited);
}

/// Is the first of a corner near a flat corner of the other outline, and the second of that flat corner on a face of
/// the first's corner?
bool CandidateFilter::past_flat_corner(const ContactPoint& beyond, const ContactPoint& flat) const {
  constexpr double near = 1e4;  // a thousandth of the structure
  if (flat.vertex_block != beyond.edge_block || flat.edge_block != beyond.vertex_block) return false;
  const auto& V = outlines_.of(beyond.vertex_block);
  const auto& E = outlines_.of(beyond.edge_block);
  const auto v = at(beyond.vertex);
  const auto w = at(flat.vertex);
  if (at(flat.edge) != v && at(flat.edge) != previous(v, V.size())) return false;
  if (w != at(beyond.edge) && w != next(at(beyond.edge), E.size())) return false;
  if ((E[w] - V[v]).norm() > near * outlines_.coincidence_m()) return false;
  const Point& in = outlines_.edges(beyond.edge_block)[previous(w, E.size())].along;
  const Point& out = outlines_.edges(beyond.edge_block)[w].along;
  return std::abs(cross(in, out)) < parallel_tolerance && in.dot(out) > 0;
}

/// Is the vertex's block on the outer side of the edge, but for what blocks strain?
bool CandidateFilter::faces_outside(const ContactPoint& c) const {
  constexpr double strained = 1e-3;  // rad
  const auto& edges = outlines_.edges(c.vertex_block);
  const Point to_before = -edges[previous(at(c.vertex), edges.size())].along;
  return faces(to_before, edges[at(c.vertex)].along, outlines_.normal_of(c), strained, 0);
}

void CandidateFilter::keep_one_of_each() {
  std::vector<std::size_t> kept_for(found_.all.size());  // by each: itself, or what it was dropped for
  for (std::size_t i = 0; i < kept_for.size(); ++i) kept_for[i] = i;
  std::vector<std::size_t> mirrored_out;
  const auto drop_for = [&](std::size_t dropped, std::size_t kept) {
    kept_for[dropped] = kept;
    if (found_.inherited[dropped] == 0 || found_.inherited[kept] != 0 ||
        found_.all[dropped].state == ContactState::open)
      return;
    static_cast<ContactMemory&>(found_.all[kept]) = found_.all[dropped];
    found_.inherited[kept] = 1;
    outlines_.count_from_start(found_.all[kept]);
  };
  for (std::size_t i = 0; i < found_.all.size(); ++i) {
    const int wi = kept_for[i] != i ? -1 : met_vertex(found_.all[i]);
    if (wi < 0) continue;
    for (std::size_t j = i + 1; j < found_.all.size() && found_.all[j].pair() == found_.all[i].pair(); ++j) {
      ContactPoint& a = found_.all[i];
      ContactPoint& b = found_.all[j];
      if (kept_for[j] != j) continue;
      const bool same = b.vertex_block == a.vertex_block && b.vertex == a.vertex && b.edge_block == a.edge_block;
      const bool mirrored = b.vertex_block == a.edge_block && b.vertex == wi && b.edge_block == a.vertex_block;
      if (!(same || mirrored) || met_vertex(b) < 0) continue;
      if (mirrored &&
          (met_vertex(b) != a.vertex || bound_overlap(a, b) || passing_.presses_too(a) || passing_.presses_too(b)))
        continue;
      // What the vertex's block is wholly on the outer side of outranks the far side of a thin block; faces that lie on
      // each other a mere meeting of corners; then memory; then the entrance edge.
      const auto rank = [&](std::size_t k) {
        const ContactPoint& c = found_.all[k];
        return std::make_tuple(faces_outside(c), c.length > 2 * outlines_.coincidence_m(),
                               found_.inherited[k] != 0 && c.state != ContactState::open, passing_.did_enter(c),
                               passing_.nearness(c));
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
  passing_.begin_stood_for();
  for (const std::size_t i : mirrored_out) {
    if (kept_for[i] < found_.all.size() && found_.all[i].gap >= -outlines_.coincidence_m())
      passing_.add_stood_for(found_.all[i]);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found_.all.size(); ++i) {
    if (kept_for[i] != i) continue;
    if (kept != i) found_.all[kept] = found_.all[i];
    ++kept;
  }
  found_.all.resize(kept);
}

/// Corners that touch in a point, as those of bricks that slide over others, press only once one has entered. By which
/// edge is seen then. Faces that share no more than blocks give way by catch on each other no longer than that.
void CandidateFilter::let_pass(std::vector<std::size_t>& kept_for) {
  const auto kept = [&](std::size_t i) {
    while (kept_for[i] != i) i = kept_for[i];
    return i;
  };
  std::vector<char> passes(found_.all.size(), 0);
  for (std::size_t i = 0; i < found_.all.size(); ++i) passes[i] = kept_for[i] == i && passes_alone(found_.all[i]);
  for (std::size_t i = 0; i < found_.all.size(); ++i) {
    if (passing_.did_enter(found_.all[i])) passes[kept(i)] = 0;
  }
  std::vector<std::size_t> let;
  for (std::size_t i = 0; i < found_.all.size(); ++i) {
    if (passes[kept(i)] != 0) passing_.add(found_.all[i]), let.push_back(i);
  }
  for (const std::size_t i : let) kept_for[i] = found_.all.size();
}

/// By itself, whatever else describes its meeting. Faces askew to the way that they pass along lie over each other by
/// their distance times a cotangent. Behind the edge counts from the edge itself: steps would add up.
bool CandidateFilter::passes_alone(const ContactPoint& c) const {
  constexpr double steepest = 10;
  constexpr double of_block = 0.2;  // of its radius: on longer ones a block as small as an offset stands
  const auto radius_of = [&](int part) { return outlines_.parts().blocks[at(part)].radius; };
  const double short_m =
      std::min(outlines_.give_m(), of_block * std::min(radius_of(c.vertex_part), radius_of(c.edge_part)));
  const bool open = c.state == ContactState::open && c.length <= std::max(short_m, steepest * c.gap);
  const bool catches = c.length > 0 && c.length <= short_m;
  return (open || catches) && c.gap + c.gap_at_start > -outlines_.give_m() && may_pass(c);
}

}  // namespace blockweir::solid
