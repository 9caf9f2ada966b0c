// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/joint_lines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/check.hpp"

namespace blockweir::solid {
namespace {

using Pair = BlockPair;

constexpr double straight = 1e-5;  // of the size: by how much points may be beside a line

/// Where a straight joint lies in the scene's outline.
struct Line {
  double angle = 0;   ///< rad, from just above -pi/2 to just above pi/2
  double offset = 0;  ///< m, of the line from `about`
};

/// None where the points are not on one line, or are one point.
std::optional<Line> line_through(const std::vector<Point>& points, const Point& about, double tolerance_m) {
  const Point& first = points.front();
  const Point& last = *std::max_element(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    return (a - first).squaredNorm() < (b - first).squaredNorm();
  });
  Point along = last - first;
  if (along.norm() <= tolerance_m) return std::nullopt;
  along.normalize();
  if (along.x() < 1e-6 && (along.x() < -1e-6 || along.y() < 0)) along = -along;
  const Point normal = perpendicular(along);
  for (const Point& p : points) {
    if (std::abs(normal.dot(p - first)) > tolerance_m) return std::nullopt;
  }
  return Line{std::atan2(along.y(), along.x()), normal.dot(first - about)};
}

}  // namespace

bool lies_on_joint(const Solid& solid, const ContactPoint& c) {
  const auto drawn = [&](int part, const Point& X) -> Point { return solid.blocks()[at(part)].centroid + X; };
  return geometry::distance_to_segment(drawn(c.vertex_part, c.vertex_at), drawn(c.edge_part, c.edge_from),
                                       drawn(c.edge_part, c.edge_to)) <= scene::rounding_ratio * solid.model().size_m;
}

JointPoints joint_points(const Solid& solid) {
  JointPoints points;
  for (const ContactPoint& c : solid.contacts()) {
    if (!lies_on_joint(solid, c)) continue;
    points[c.pair()].push_back(solid.blocks()[at(c.vertex_part)].centroid + c.vertex_at);
  }
  return points;
}

bool is_point(const Solid& solid, const std::vector<Point>& points) {
  const double tolerance_m = straight * solid.model().size_m;
  return std::all_of(points.begin(), points.end(),
                     [&](const Point& p) { return (p - points.front()).norm() <= tolerance_m; });
}

bool is_straight(const Solid& solid, const std::vector<Point>& points) {
  return line_through(points, Point::Zero(), straight * solid.model().size_m).has_value();
}

std::vector<std::set<Pair>> in_one_line(const Solid& solid, const JointPoints& points) {
  const double tolerance_m = straight * solid.model().size_m;
  constexpr double parallel = 1e-4;  // rad
  std::vector<std::pair<Line, Pair>> lines;
  const Point about = points.empty() ? Point::Zero() : points.begin()->second.front();
  for (const auto& [pair, at_points] : points) {
    if (const auto line = line_through(at_points, about, tolerance_m)) lines.emplace_back(*line, pair);
  }
  const auto by_angle = [](const auto& a, const auto& b) { return a.first.angle < b.first.angle; };
  const auto by_offset = [](const auto& a, const auto& b) { return a.first.offset < b.first.offset; };
  std::sort(lines.begin(), lines.end(), by_angle);
  std::vector<std::set<Pair>> groups;
  for (auto first = lines.begin(), end = first; first != lines.end(); first = end) {
    end = std::adjacent_find(first, lines.end(),
                             [&](const auto& a, const auto& b) { return b.first.angle - a.first.angle > parallel; });
    if (end != lines.end()) ++end;
    std::sort(first, end, by_offset);
    for (auto one = first, next = one; one != end; one = next) {
      std::set<Pair> group;
      for (next = one; next != end && (next == one || next->first.offset - (next - 1)->first.offset <= tolerance_m);
           ++next)
        group.insert(next->second);
      if (group.size() > 1) groups.push_back(std::move(group));
    }
  }
  return groups;
}

std::vector<std::set<Pair>> parted_by_gaps(const Solid& solid, const JointPoints& points, const std::set<Pair>& line) {
  struct Extent {
    double from_m;
    double to_m;
    Pair pair;
  };
  std::vector<Point> all;
  for (const Pair& pair : line) all.insert(all.end(), points.at(pair).begin(), points.at(pair).end());
  const Point& first = all.front();
  const Point along = (*std::max_element(all.begin(), all.end(),
                                         [&](const Point& a, const Point& b) {
                                           return (a - first).squaredNorm() < (b - first).squaredNorm();
                                         }) -
                       first)
                          .normalized();
  std::vector<Extent> extents;
  for (const Pair& pair : line) {
    const auto [low, high] = std::minmax_element(points.at(pair).begin(), points.at(pair).end(),
                                                 [&](const Point& a, const Point& b) { return along.dot(a - b) < 0; });
    extents.push_back({along.dot(*low - first), along.dot(*high - first), pair});
  }
  std::sort(extents.begin(), extents.end(), [](const auto& a, const auto& b) { return a.from_m < b.from_m; });
  std::vector<std::set<Pair>> parts;
  std::set<int> blocks;  // of the last part, that can move
  double end_m = 0;
  double length_m = 0;  // of the joint that ends there
  for (const Extent& s : extents) {
    const bool spanned = blocks.contains(s.pair.first) || blocks.contains(s.pair.second);
    const double own_m = s.to_m - s.from_m;
    if (parts.empty() || (!spanned && s.from_m - end_m > std::min(length_m, own_m)))
      parts.emplace_back(), blocks.clear();
    parts.back().insert(s.pair);
    for (const int b : {s.pair.first, s.pair.second}) {
      if (!solid.blocks()[at(b)].fixed) blocks.insert(b);
    }
    if (parts.back().size() == 1 || s.to_m > end_m) end_m = s.to_m, length_m = own_m;
  }
  return parts;
}

}  // namespace blockweir::solid
