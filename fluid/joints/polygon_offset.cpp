// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/polygon_offset.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::joints {
namespace {

using geometry::cross;

constexpr double sharpest_mitre =
    -0.766;  // cosine of a turn of 140 degrees: the corner grows by 2.92 times the distance

Point right_of(const Point& direction) {
  return {direction.y(), -direction.x()};
}

struct MovedEdge {
  Piece piece;
  Point along;
  double distance_m;
  double before_m = 0;  ///< shift of its start to the intersection with its neighbour
  double after_m = 0;   ///< and ends
  /// Or has no length left, but for round-off.
  [[nodiscard]] bool turned_round() const {
    return (piece.to - piece.from).dot(along) + after_m - before_m <= 1e-9 * std::abs(distance_m);
  }
};

void meet(MovedEdge& in, MovedEdge& out) {
  constexpr double straight = 0.99;  // there the crossing of two lines is told badly
  constexpr double longest = 10;
  const double turn = cross(in.along, out.along);
  const double ahead = in.along.dot(out.along);
  const Point gap = out.piece.from - in.piece.to;
  if (ahead > straight) {
    in.after_m = gap.dot(in.along) / (1 + ahead);
    out.before_m = -gap.dot(out.along) / (1 + ahead);
  } else if (std::abs(turn) < 1e-9) {
    in.after_m = out.before_m = 0;
  } else {
    const double most = longest * std::max(std::abs(in.distance_m), std::abs(out.distance_m));
    in.after_m = std::clamp(cross(gap, out.along) / turn, -most, most);
    out.before_m = std::clamp(cross(gap, in.along) / turn, -most, most);
  }
}

}  // namespace

Ring grown(const Ring& outline, double distance_m) {
  const std::size_t n = outline.size();
  Ring line;
  line.reserve(n + 4);
  Point way = outline.front() - outline.back();
  double length = way.norm();
  Point in = way / length;
  for (std::size_t i = 0; i < n; ++i) {
    const Point& p = outline[i];
    const double length_before = length;
    way = outline[(i + 1) % n] - p;
    length = way.norm();
    const Point out = way / length;
    const Point in_right = right_of(in);
    const Point out_right = right_of(out);
    const double turn = cross(in, out);
    const double ahead = in.dot(out);
    // A mitre shortens both edges of a reflex corner by distance * tan(turn/2); half of each is this corner's.
    const bool roomy = 2 * distance_m * -turn < (1 + ahead) * std::min(length_before, length);
    if (turn < 0 && !roomy) {
      line.insert(line.end(), {p + distance_m * in_right, p, p + distance_m * out_right});
    } else if (turn < 0 || ahead >= sharpest_mitre) {
      line.emplace_back(p + distance_m / (1 + ahead) * (in_right + out_right));
    } else {  // cut off as far from the corner as the sides are, so that the cut moves back onto it
      const double further_m = distance_m * (1 - std::sqrt((1 + ahead) / 2)) / std::sqrt((1 - ahead) / 2);
      line.insert(line.end(),
                  {p + distance_m * in_right + further_m * in, p + distance_m * out_right - further_m * out});
    }
    in = out;
  }
  return line;
}

std::vector<Piece> moved_right(const Ring& ring, const std::vector<double>& right_m) {
  const std::size_t n = ring.size();
  std::vector<MovedEdge> edges(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point& to = ring[(i + 1) % n];
    const Point along = (to - ring[i]).normalized();
    const Point way = right_m[i] * right_of(along);
    edges[i] = {{ring[i] + way, to + way}, along, right_m[i]};
  }
  do {
    for (std::size_t i = 0; i < edges.size(); ++i) meet(edges[i], edges[(i + 1) % edges.size()]);
  } while (std::erase_if(edges, [](const MovedEdge& e) { return e.turned_round(); }) > 0);
  std::vector<Piece> pieces;
  for (const auto& [piece, along, distance, before, after] : edges) {
    pieces.push_back({piece.from + before * along, piece.to + after * along});
  }
  return pieces;
}

}  // namespace blockweir::joints
