// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/contact_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/touching_pairs.hpp"

namespace blockweir::solid {
namespace {

constexpr double flat = 1e-2;  // rad
constexpr double at_vertex = 1e-9;

using scene::TracePiece;
using Pieces = std::vector<TracePiece>;

/// A stretch of a block's outline, between places that are an edge plus a fraction of it, against the clock.
struct Stretch {
  double from = 0;
  double to = 0;
  Point from_m;
  Point to_m;
};

/// Of one block: its joints piece by piece, and the rows of pieces that a chord replaces.
struct Joined {
  std::vector<Stretch> pieces;
  std::vector<Stretch> chords;
};

/// Calls `found(first, last)` for each longest row of points whose lines deviate from its chord by less than `flat`.
template <class Found>
void straight_rows(const std::vector<Point>& points, std::size_t first, std::size_t last, const Found& found) {
  if (last - first < 2) return;
  const Point chord = (points[last] - points[first]).normalized();
  bool straight = true;
  std::size_t split = first + 1;
  double farthest_m = -1;
  for (std::size_t i = first; i < last; ++i) {
    const Point along = (points[i + 1] - points[i]).normalized();
    straight = straight && along.dot(chord) > 0 && std::abs(geometry::cross(along, chord)) < flat;
    const double off_m = std::abs(geometry::cross(chord, points[i] - points[first]));
    if (i > first && off_m > farthest_m) {
      farthest_m = off_m;
      split = i;
    }
  }
  if (straight) return found(first, last);
  straight_rows(points, first, split, found);
  straight_rows(points, split, last, found);
}

/// Of block a or b, along which or against which the trace runs.
Stretch stretch_of(const TracePiece& from, const TracePiece& to, bool of_a) {
  const double first = of_a ? from.edge_a + from.s_from_a : from.edge_b + from.s_from_b;
  const double last = of_a ? to.edge_a + to.s_to_a : to.edge_b + to.s_to_b;
  const bool forwards = of_a ? from.s_from_a < from.s_to_a : from.s_from_b < from.s_to_b;
  return forwards ? Stretch{first, last, from.from_m, to.to_m} : Stretch{last, first, to.to_m, from.from_m};
}

/// `pieces` without a gap.
void add_joint(const Pieces& pieces, Joined& a, Joined& b) {
  std::vector<Point> points = {pieces.front().from_m};
  for (const TracePiece& piece : pieces) {
    points.push_back(piece.to_m);
    a.pieces.push_back(stretch_of(piece, piece, true));
    b.pieces.push_back(stretch_of(piece, piece, false));
  }
  straight_rows(points, 0, pieces.size(), [&](std::size_t first, std::size_t last) {
    a.chords.push_back(stretch_of(pieces[first], pieces[last - 1], true));
    b.chords.push_back(stretch_of(pieces[first], pieces[last - 1], false));
  });
}

/// A vertex of the new outline, at its place on the old one.
struct Corner {
  double place = 0;
  Point at_m;
  bool keep = false;   ///< a vertex that no chord passes, or the end of a chord
  bool third = false;  ///< two other blocks meet there
};

/// Places on an outline of n edges.
class Places {
 public:
  Places(const std::vector<Stretch>& stretches, double Stretch::*place, double n) {
    for (const Stretch& stretch : stretches) {
      const double at = stretch.*place;
      sorted_.push_back(at > n - at_vertex ? at - n : at);
    }
    std::sort(sorted_.begin(), sorted_.end());
  }
  [[nodiscard]] bool have(double place) const {
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), place - at_vertex);
    return found != sorted_.end() && *found < place + at_vertex;
  }

 private:
  std::vector<double> sorted_;
};

/// Vertices that no chord passes, and all ends of joints between them.
std::vector<Corner> corners_of(const scene::Block& block, const Joined& joined) {
  const auto n = static_cast<double>(block.vertices.size());
  const auto passed = [&](double place) {
    return std::any_of(joined.chords.begin(), joined.chords.end(), [&](const Stretch& chord) {
      const double length = chord.to < chord.from ? chord.to + n - chord.from : chord.to - chord.from;
      const double since = place < chord.from ? place + n - chord.from : place - chord.from;
      return since > at_vertex && since < length - at_vertex;
    });
  };
  std::vector<Corner> corners;
  const auto add = [&](double place, const Point& at_m, bool keep) {
    const bool vertex = std::abs(place - std::round(place)) < at_vertex;
    if (!vertex && !passed(place)) corners.push_back({place, at_m, keep, false});
  };
  for (std::size_t v = 0; v < block.vertices.size(); ++v) {
    if (!passed(static_cast<double>(v))) corners.push_back({static_cast<double>(v), block.vertices[v], true, false});
  }
  for (const Stretch& chord : joined.chords) add(chord.from, chord.from_m, true), add(chord.to, chord.to_m, true);
  for (const Stretch& piece : joined.pieces) add(piece.from, piece.from_m, false), add(piece.to, piece.to_m, false);
  std::stable_sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.place < b.place; });
  const auto same = [](const Corner& a, const Corner& b) { return b.place - a.place < at_vertex; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());  // the first is one to keep
  const Places begins(joined.pieces, &Stretch::from, n);
  const Places ends(joined.pieces, &Stretch::to, n);
  for (Corner& corner : corners) corner.third = begins.have(corner.place) && ends.have(corner.place);
  return corners;
}

/// Points that rows of joints along a block have moved onto their chords.
class Moved {
 public:
  explicit Moved(double touching_m) : touching_m_(touching_m) {}

  void add(const Point& from, const Point& to) { all_.push_back({from, to}); }
  void finish() {
    std::sort(all_.begin(), all_.end(), [](const auto& a, const auto& b) { return a.first.x() < b.first.x(); });
  }
  [[nodiscard]] Point operator()(const Point& point) const {
    const auto left = [](const auto& a, double x) { return a.first.x() < x; };
    for (auto it = std::lower_bound(all_.begin(), all_.end(), point.x() - touching_m_, left);
         it != all_.end() && it->first.x() <= point.x() + touching_m_; ++it) {
      if ((it->first - point).norm() <= touching_m_) return it->second;
    }
    return point;
  }

 private:
  double touching_m_;
  std::vector<std::pair<Point, Point>> all_;
};

/// Where other blocks meet along a block, as on surveyed rock, they meet on the chord of a row that is nearly straight.
void straighten(std::vector<Corner>& corners, double rounding_m, Moved& moved) {
  const auto real = std::find_if(corners.begin(), corners.end(), [](const Corner& c) { return !c.third; });
  if (real == corners.end()) return;
  std::rotate(corners.begin(), real, corners.end());
  const std::size_t n = corners.size();
  for (std::size_t first = 0; first < n;) {
    std::size_t last = first + 1;
    while (last < n && corners[last].third) ++last;
    std::vector<Point> points;
    for (std::size_t i = first; i <= last; ++i) points.push_back(corners[i % n].at_m);
    straight_rows(points, 0, points.size() - 1, [&](std::size_t from, std::size_t to) {
      const Point along = (points[to] - points[from]).normalized();
      double off_m = 0;
      for (std::size_t i = from + 1; i < to; ++i) {
        off_m = std::max(off_m, std::abs(geometry::cross(along, points[i] - points[from])));
      }
      if (off_m < rounding_m) return;
      for (std::size_t i = from + 1; i < to; ++i) {
        moved.add(points[i], points[from] + along.dot(points[i] - points[from]) * along);
        corners[first + i].keep = false;
      }
      for (const std::size_t end : {from, to}) corners[(first + end) % n].keep = true;
    });
    first = last;
  }
}

ContactOutline outline_of(int number, const Block& block, std::vector<Corner> corners, const Moved& moved) {
  std::erase_if(corners, [](const Corner& c) { return !c.keep; });
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.place < b.place; });
  const auto material = [&](const Corner& corner) -> Point {
    const Point at_m = moved(corner.at_m);
    const auto vertex = static_cast<std::size_t>(std::lround(corner.place));
    const bool as_drawn = corner.place == static_cast<double>(vertex) && at_m == corner.at_m;
    return as_drawn ? block.vertices[vertex] : at_m - block.centroid;
  };
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
                       .from = material(from),
                       .to = material(to)});
  }
  return outline;
}

}  // namespace

std::vector<ContactOutline> contact_outlines(const scene::Scene& scene, const std::vector<Block>& blocks) {
  const double touching_m = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  const auto meshed = [&](int b) { return scene.blocks[at(b)].mesh_size_m > 0; };
  std::vector<Joined> joined(scene.blocks.size());
  for (const auto& [pair, trace] : scene::touching_joints(scene, touching_m)) {
    const auto [a, b] = pair;
    if (meshed(a) || meshed(b)) continue;
    const Pieces& pieces = trace.pieces;
    for (std::size_t first = 0, last = 0; first < pieces.size(); first = last) {
      for (last = first + 1; last < pieces.size(); ++last) {
        if ((pieces[last].from_m - pieces[last - 1].to_m).norm() > touching_m) break;
      }
      add_joint(Pieces(pieces.begin() + static_cast<long>(first), pieces.begin() + static_cast<long>(last)),
                joined[at(a)], joined[at(b)]);
    }
  }
  std::vector<std::vector<Corner>> corners(scene.blocks.size());
  Moved moved(touching_m);
  for (std::size_t b = 0; b < corners.size(); ++b) {
    corners[b] = corners_of(scene.blocks[b], joined[b]);
    straighten(corners[b], touching_m, moved);
  }
  moved.finish();
  std::vector<ContactOutline> outlines(scene.blocks.size());
  for (int b = 0; b < static_cast<int>(outlines.size()); ++b) {
    if (!meshed(b)) outlines[at(b)] = outline_of(b, blocks[at(b)], std::move(corners[at(b)]), moved);
  }
  return outlines;
}

}  // namespace blockweir::solid
