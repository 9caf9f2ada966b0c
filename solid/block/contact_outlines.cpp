// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/contact_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/touching_pairs.hpp"

namespace blockweir::solid {
namespace {

constexpr double flat = 1e-2;  // rad
constexpr double at_vertex = 1e-9;

using scene::TracePiece;
using Pieces = std::vector<TracePiece>;

/// A stretch of a block's outline that is replaced by its chord: places as edge plus fraction, against the clock.
struct Chord {
  double from = 0;
  double to = 0;
  Point from_m;
  Point to_m;
};

/// Calls `found(first, last)` for each longest row of pieces [first, last) that its chord replaces.
template <class Found>
void straight_rows(const Pieces& pieces, std::size_t first, std::size_t last, const Found& found) {
  if (last - first < 2) return;
  const Point start = pieces[first].from_m;
  const Point chord = (pieces[last - 1].to_m - start).normalized();
  bool straight = true;
  std::size_t split = first + 1;
  double farthest_m = -1;
  for (std::size_t i = first; i < last; ++i) {
    const Point along = (pieces[i].to_m - pieces[i].from_m).normalized();
    straight = straight && along.dot(chord) > 0 && std::abs(geometry::cross(along, chord)) < flat;
    const double off_m = std::abs(geometry::cross(chord, pieces[i].from_m - start));
    if (i > first && off_m > farthest_m) {
      farthest_m = off_m;
      split = i;
    }
  }
  if (straight) return found(first, last);
  straight_rows(pieces, first, split, found);
  straight_rows(pieces, split, last, found);
}

/// The trace runs along one of its blocks, and against the other.
Chord chord_of(int from_edge, double s_from, int to_edge, double s_to, const Point& from_m, const Point& to_m,
               bool forwards) {
  const double a = from_edge + s_from;
  const double b = to_edge + s_to;
  return forwards ? Chord{a, b, from_m, to_m} : Chord{b, a, to_m, from_m};
}

void add_chords(const Pieces& pieces, std::size_t first, std::size_t last, std::vector<Chord>& of_a,
                std::vector<Chord>& of_b) {
  straight_rows(pieces, first, last, [&](std::size_t i, std::size_t end) {
    const TracePiece& from = pieces[i];
    const TracePiece& to = pieces[end - 1];
    of_a.push_back(
        chord_of(from.edge_a, from.s_from_a, to.edge_a, to.s_to_a, from.from_m, to.to_m, from.s_from_a < from.s_to_a));
    of_b.push_back(
        chord_of(from.edge_b, from.s_from_b, to.edge_b, to.s_to_b, from.from_m, to.to_m, from.s_from_b < from.s_to_b));
  });
}

/// A vertex of the new outline, at its place on the old one.
struct Corner {
  double place;
  Point material;
};

/// Vertices that no chord passes, and ends of chords between vertices.
std::vector<Corner> corners_left(const Block& block, const std::vector<Chord>& chords) {
  const auto n = static_cast<double>(block.vertices.size());
  const auto wrapped = [n](double place) { return place >= n ? place - n : place; };
  std::vector<Corner> corners;
  for (std::size_t v = 0; v < block.vertices.size(); ++v) {
    const auto place = static_cast<double>(v);
    const bool passed = std::any_of(chords.begin(), chords.end(), [&](const Chord& chord) {
      const double length = chord.to < chord.from ? chord.to + n - chord.from : chord.to - chord.from;
      const double since = place < chord.from ? place + n - chord.from : place - chord.from;
      return since > at_vertex && since < length - at_vertex;
    });
    if (!passed) corners.push_back({place, block.vertices[v]});
  }
  for (const Chord& chord : chords) {
    for (const auto& [place, point_m] : {std::pair(chord.from, chord.from_m), std::pair(chord.to, chord.to_m)}) {
      if (std::abs(place - std::round(place)) > at_vertex)
        corners.push_back({wrapped(place), point_m - block.centroid});
    }
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.place < b.place; });
  // Where a third block stands on the other two, their chords meet.
  const auto same = [](const Corner& a, const Corner& b) { return b.place - a.place < at_vertex; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  return corners;
}

ContactOutline outline_of(int number, const Block& block, const std::vector<Chord>& chords) {
  const std::vector<Corner> corners = corners_left(block, chords);
  ContactOutline outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& from = corners[i];
    const Corner& to = corners[(i + 1) % corners.size()];
    const double edge = std::floor(from.place);
    const bool on_same_edge = std::floor(to.place) == edge && to.place > from.place;
    outline.push_back({.part = number,
                       .described_edge = static_cast<int>(edge),
                       .s_from = from.place - edge,
                       .s_to = on_same_edge ? to.place - edge : 1,
                       .from = from.material,
                       .to = to.material});
  }
  return outline;
}

}  // namespace

std::vector<ContactOutline> contact_outlines(const scene::Scene& scene, const std::vector<Block>& blocks) {
  const double touching_m = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  std::vector<std::vector<Chord>> chords(scene.blocks.size());
  for (const auto& [a, b] : scene::touching_pairs(scene, touching_m)) {
    if (scene.blocks[at(a)].mesh_size_m > 0 || scene.blocks[at(b)].mesh_size_m > 0) continue;
    const Pieces pieces = scene::trace_joint(scene.blocks[at(a)], scene.blocks[at(b)], touching_m).pieces;
    for (std::size_t first = 0, last = 0; first < pieces.size(); first = last) {  // without a gap
      for (last = first + 1; last < pieces.size(); ++last) {
        if ((pieces[last].from_m - pieces[last - 1].to_m).norm() > touching_m) break;
      }
      add_chords(pieces, first, last, chords[at(a)], chords[at(b)]);
    }
  }
  std::vector<ContactOutline> outlines(scene.blocks.size());
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    if (scene.blocks[b].mesh_size_m <= 0) outlines[b] = outline_of(static_cast<int>(b), blocks[b], chords[b]);
  }
  return outlines;
}

}  // namespace blockweir::solid
