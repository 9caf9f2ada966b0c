// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/pool_outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace blockweir::hydrostatic {
namespace {

__extension__ using Wide = __int128;  // products of coordinates are exact

struct Vertex {
  std::int64_t x;
  std::int64_t y;
  bool operator==(const Vertex&) const = default;
};

Vertex to_units(const Point& p) {
  const auto whole = [](double metres) {
    return static_cast<std::int64_t>(metres / outline_unit_m + std::copysign(0.5, metres));
  };
  return {whole(p.x()), whole(p.y())};
}

Point to_metres(const Vertex& v) {
  return {static_cast<double>(v.x) * outline_unit_m, static_cast<double>(v.y) * outline_unit_m};
}

/// With the water on its left, where there is any.
struct Edge {
  Vertex from;
  Vertex to;
  int on;
  std::size_t next;  ///< of the same closed line
  [[nodiscard]] Point at(double t) const {
    const Point a = to_metres(from);
    return a + t * (to_metres(to) - a);
  }
};

/// Twice the area of the triangle from an edge to a vertex; positive on the edge's left.
Wide side(const Edge& e, const Vertex& v) {
  return static_cast<Wide>(e.to.x - e.from.x) * (v.y - e.from.y) -
         static_cast<Wide>(e.to.y - e.from.y) * (v.x - e.from.x);
}

bool on_one_side(Wide a, Wide b) {
  return (a > 0 && b > 0) || (a < 0 && b < 0);
}

struct Box {
  Vertex low{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::max()};
  Vertex high{std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min()};
  void add(const Vertex& v) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  }
  [[nodiscard]] bool meets(const Box& o) const {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
};

Box box_of(const Edge& e) {
  Box box;
  box.add(e.from);
  box.add(e.to);
  return box;
}

/// The frame or an obstacle.
struct Line {
  std::size_t begin;  ///< its edges
  std::size_t end;
  Box box{};
  std::size_t lowest = 0;  ///< the edge from its lowest corner
  bool met = false;        ///< on a walk
};

struct Crossing {
  double t;  ///< along the edge, 0..1
  std::size_t other;
};

bool is_inside(const Ring& ring, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    inside ^= p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
  }
  return inside;
}

/// In the first ring and in none of the others, which are its holes.
bool is_in_water(const Point& p, const std::vector<OutlineRing>& rings) {
  for (const OutlineRing& ring : rings) {
    if (is_inside(ring.corner, p) != (&ring == &rings.front())) return false;
  }
  return true;
}

/// Walks with the water on the left: whatever crosses the way has water on its left, too, and the way goes on along it.
class Walks {
 public:
  explicit Walks(std::size_t corners) { edges_.reserve(corners); }

  void add(const Ring& ring, int on, bool reversed) {
    Line line{edges_.size(), edges_.size()};
    Vertex from = ring.empty() ? Vertex{} : to_units(reversed ? ring.front() : ring.back());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex to = to_units(ring[reversed ? ring.size() - 1 - i : i]);
      if (from != to) edges_.push_back({from, to, on, edges_.size() + 1});
      from = to;
    }
    if (edges_.size() == line.begin) return;
    line.end = edges_.size();
    edges_.back().next = line.begin;
    line.lowest = line.begin;
    for (std::size_t e = line.begin; e < line.end; ++e) {
      line.box.add(edges_[e].from);
      if (is_lower(e, line.lowest)) line.lowest = e;
    }
    lines_.push_back(line);
  }

  /// The ring of the outline through the beginning of an edge that has the water on its left there. No value where
  /// edges of the ring touch others.
  std::optional<OutlineRing> walk(std::size_t start) {
    OutlineRing ring;
    std::size_t edge = start;
    std::size_t came_from = start;
    Point corner = to_metres(edges_[start].from);
    do {
      ring.corner.push_back(corner);
      ring.on.push_back(edges_[edge].on);
      if (!cross_others(edge)) return std::nullopt;
      auto next = crossings_.begin();
      if (came_from != edge) {
        next = std::find_if(next, crossings_.end(), [&](const Crossing& c) { return c.other == came_from; }) + 1;
      }
      if (next == crossings_.end()) {
        came_from = edge = edges_[edge].next;
        corner = to_metres(edges_[edge].from);
      } else {
        corner = edges_[edge].at(next->t);
        came_from = std::exchange(edge, next->other);
      }
    } while (edge != start || came_from != start);
    return ring;
  }

  /// Of the obstacles that lie in the water and were met by no walk: the edge from the lowest corner of all, which is
  /// on the outline of an island.
  [[nodiscard]] std::optional<std::size_t> unmet_island(const std::vector<OutlineRing>& rings) const {
    std::optional<std::size_t> lowest;
    for (const Line& line : lines_) {
      if (line.met || (lowest && !is_lower(line.lowest, *lowest))) continue;
      if (is_in_water(to_metres(edges_[line.lowest].from), rings)) lowest = line.lowest;
    }
    return lowest;
  }

 private:
  [[nodiscard]] bool is_lower(std::size_t a, std::size_t b) const {
    return std::pair(edges_[a].from.y, edges_[a].from.x) < std::pair(edges_[b].from.y, edges_[b].from.x);
  }

  /// All crossings on an edge, in order; false where others touch it, or two cross it in one point.
  bool cross_others(std::size_t edge) {
    const Box box = box_of(edges_[edge]);
    crossings_.clear();
    for (Line& line : lines_) {
      if (line.begin <= edge && edge < line.end) line.met = true;
      if (!line.box.meets(box)) continue;
      for (std::size_t other = line.begin; other < line.end; ++other) {
        if (box.meets(box_of(edges_[other])) && !cross(edge, other)) return false;
      }
    }
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    constexpr double as_good_as_one = 1e-15;  // fractions of an edge are rounded to less
    return std::adjacent_find(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
             return b.t - a.t < as_good_as_one;
           }) == crossings_.end();
  }

  bool cross(std::size_t edge, std::size_t other) {
    const Edge& a = edges_[edge];
    const Edge& b = edges_[other];
    if (edge == other || a.next == other || b.next == edge) return true;
    const Wide b_from = side(a, b.from);
    const Wide b_to = side(a, b.to);
    if (on_one_side(b_from, b_to)) return true;
    const Wide a_from = side(b, a.from);
    const Wide a_to = side(b, a.to);
    if (on_one_side(a_from, a_to)) return true;
    if (a_from == 0 || a_to == 0 || b_from == 0 || b_to == 0) return false;
    crossings_.push_back({static_cast<double>(a_from) / static_cast<double>(a_from - a_to), other});
    return true;
  }

  std::vector<Edge> edges_;
  std::vector<Line> lines_;
  std::vector<Crossing> crossings_;  ///< of the edge that was asked for last
};

}  // namespace

std::optional<std::vector<OutlineRing>> pool_outline(const Ring& frame, FrameSide side,
                                                     const std::vector<Ring>& obstacles) {
  std::size_t corners = frame.size();
  for (const Ring& obstacle : obstacles) corners += obstacle.size();
  Walks walks(corners);
  walks.add(frame, OutlineRing::frame, /*reversed=*/false);
  for (std::size_t k = 0; k < obstacles.size(); ++k) walks.add(obstacles[k], static_cast<int>(k), /*reversed=*/true);
  std::vector<OutlineRing> rings;
  std::optional<std::size_t> start = side == FrameSide::left ? 0 : 2;
  for (; start; start = walks.unmet_island(rings)) {
    std::optional<OutlineRing> ring = walks.walk(*start);
    if (!ring) return std::nullopt;
    rings.push_back(std::move(*ring));
  }
  return rings;
}

}  // namespace blockweir::hydrostatic
