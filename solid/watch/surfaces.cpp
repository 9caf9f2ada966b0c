// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bridge/scene/at.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/viscous_ground.hpp"
#include "solid/watch/joint_name.hpp"

namespace blockweir::solid {
namespace {

using Pair = std::pair<int, int>;

constexpr double straight = 1e-5;  // of the size: by how much points may be beside a line
/// Where a straight joint lies in the scene's outline.
struct Line {
  double angle = 0;   ///< rad, from just above -pi/2 to just above pi/2
  double offset = 0;  ///< m, of the line from `about`
};

bool is_point(const std::vector<Point>& points, double tolerance_m) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Point& p) { return (p - points.front()).norm() <= tolerance_m; });
}

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

/// The graph of blocks that touch, the ground being one node.
class Connections {
 public:
  Connections(const Solid& solid, const std::vector<Pair>& pairs) : solid_(solid), edges_(solid.described() + 1) {
    for (const Pair& pair : pairs) {
      const int a = node(pair.first);
      const int b = node(pair.second);
      if (a == b) continue;
      edges_[at(a)].emplace_back(b, pair);
      edges_[at(b)].emplace_back(a, pair);
    }
    grounded_ = reached({});
    part_structures();
  }

  /// Blocks that the ground is connected to.
  struct Reach {
    std::size_t count = 0;
    double weight_n_per_m = 0;
  };
  /// What loses its connection to the ground without these joints.
  [[nodiscard]] Reach parted_by(const std::set<Pair>& joints) const {
    const Reach left = reached(joints);
    return {grounded_.count - left.count, grounded_.weight_n_per_m - left.weight_n_per_m};
  }

  /// The joints of each structure separately: structures that only share the ground stand and fail on their own.
  [[nodiscard]] std::vector<std::set<Pair>> by_structure(const std::set<Pair>& joints) const {
    std::map<int, std::set<Pair>> apart;
    for (const Pair& pair : joints) apart[std::max(structure_of(pair.first), structure_of(pair.second))].insert(pair);
    std::vector<std::set<Pair>> all;
    for (auto& [structure, own] : apart) all.push_back(std::move(own));
    return all;
  }

 private:
  [[nodiscard]] int structure_of(int block) const {
    const int n = node(block);
    return n == ground() ? -1 : structure_[at(n)];
  }
  [[nodiscard]] int ground() const { return static_cast<int>(edges_.size()) - 1; }
  /// Numbers what hangs together without the ground.
  void part_structures() {
    structure_.assign(edges_.size() - 1, -1);
    for (std::size_t first = 0; first < structure_.size(); ++first) {
      if (structure_[first] >= 0) continue;
      std::vector<std::size_t> open = {first};
      structure_[first] = static_cast<int>(first);
      while (!open.empty()) {
        const std::size_t from = open.back();
        open.pop_back();
        for (const auto& [to, pair] : edges_[from]) {
          if (to == ground() || structure_[at(to)] >= 0) continue;
          structure_[at(to)] = static_cast<int>(first);
          open.push_back(at(to));
        }
      }
    }
  }
  [[nodiscard]] int node(int block) const {
    const auto& supports = solid_.scene().supports;
    const auto holds = [&](const scene::Support& s) { return s.block == block; };
    const bool held = solid_.blocks()[at(block)].fixed || std::any_of(supports.begin(), supports.end(), holds) ||
                      scene::is_viscous_ground(solid_.scene(), block);
    return held ? ground() : block;
  }
  [[nodiscard]] Reach reached(const std::set<Pair>& without) const {
    std::vector<bool> seen(edges_.size(), false);
    std::vector<std::size_t> open = {edges_.size() - 1};
    seen.back() = true;
    Reach reach;
    while (!open.empty()) {
      const std::size_t from = open.back();
      open.pop_back();
      for (const auto& [to, pair] : edges_[from]) {
        if (seen[at(to)] || without.contains(pair)) continue;
        seen[at(to)] = true;
        open.push_back(at(to));
        ++reach.count;
        reach.weight_n_per_m += solid_.blocks()[at(to)].mass_per_m() * solid_.scene().analysis.gravity_m_per_s2;
      }
    }
    return reach;
  }

  const Solid& solid_;
  std::vector<std::vector<std::pair<int, Pair>>> edges_;
  std::vector<int> structure_;  ///< of each block, by the first block in it
  Reach grounded_;
};

/// Outline points of each joint: vertices that lie on an edge of the other block there, whether they press on it now or
/// not.
std::map<Pair, std::vector<Point>> joint_points(const Solid& solid) {
  const double touching_m = scene::rounding_ratio * solid.size_m();
  std::map<Pair, std::vector<Point>> points;
  for (const ContactPoint& c : solid.contacts()) {
    const Point vertex = solid.blocks()[at(c.vertex_part)].centroid + c.vertex_at;
    const Point from = solid.blocks()[at(c.edge_part)].centroid + c.edge_from;
    const Point along = c.edge_to - c.edge_from;
    const double share = std::clamp(along.dot(vertex - from) / along.squaredNorm(), 0.0, 1.0);
    if ((from + share * along - vertex).norm() <= touching_m) points[c.pair()].push_back(vertex);
  }
  return points;
}

/// Joints that lie in one line, two or more.
std::vector<std::set<Pair>> in_one_line(const Solid& solid, const std::map<Pair, std::vector<Point>>& points) {
  const double tolerance_m = straight * solid.size_m();
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

/// Joints in one line, apart where a gap is wider than a joint beside it and no block spans it: the springings of an
/// arch have no common resultant.
std::vector<std::set<Pair>> parted_by_gaps(const Solid& solid, const std::map<Pair, std::vector<Point>>& points,
                                           const std::set<Pair>& line) {
  struct Stretch {
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
  std::vector<Stretch> stretches;
  for (const Pair& pair : line) {
    const auto [low, high] = std::minmax_element(points.at(pair).begin(), points.at(pair).end(),
                                                 [&](const Point& a, const Point& b) { return along.dot(a - b) < 0; });
    stretches.push_back({along.dot(*low - first), along.dot(*high - first), pair});
  }
  std::sort(stretches.begin(), stretches.end(), [](const auto& a, const auto& b) { return a.from_m < b.from_m; });
  std::vector<std::set<Pair>> parts;
  std::set<int> blocks;  // of the last part, that can move
  double end_m = 0;
  double length_m = 0;  // of the joint that ends there
  for (const Stretch& s : stretches) {
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

std::string name_of(const Solid& solid, const std::set<Pair>& joints) {
  const Pair& first = *joints.begin();
  const std::string own = joint_name(solid, first.first, first.second);
  if (joints.size() == 1) return own;
  const std::string set = joint_set(solid, first.first, first.second);
  const auto in_set = [&](const Pair& p) { return joint_set(solid, p.first, p.second) == set; };
  if (!set.empty() && std::all_of(joints.begin(), joints.end(), in_set)) return set;
  return fmt::format("{} and {} more in one line", own, joints.size() - 1);
}

/// Pairs of blocks with a face in common: corners that touch in a point hold nothing together.
std::vector<Pair> that_touch(const std::map<Pair, std::vector<Point>>& points, double tolerance_m) {
  std::vector<Pair> pairs;
  for (const auto& [pair, at_points] : points) {
    if (!is_point(at_points, tolerance_m)) pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

Surfaces::Surfaces(const Solid& solid) {
  const std::map<Pair, std::vector<Point>> points = joint_points(solid);
  const double tolerance_m = straight * solid.size_m();
  const std::vector<Pair> pairs = that_touch(points, tolerance_m);
  const Connections connections(solid, pairs);
  std::vector<std::set<Pair>> candidates;
  for (const std::set<Pair>& line : in_one_line(solid, points)) {
    for (const std::set<Pair>& own : connections.by_structure(line)) {
      for (std::set<Pair>& joints : parted_by_gaps(solid, points, own)) {
        if (joints.size() > 1) candidates.push_back(std::move(joints));
      }
    }
  }
  // A bent surface, such as a dam's base with its toe in the ground, cannot slide on one of its faces alone.
  for (const Pair& pair : pairs) {
    if (line_through(points.at(pair), Point::Zero(), tolerance_m)) candidates.push_back({pair});
  }
  for (const std::set<Pair>& joints : candidates) {
    const Connections::Reach parted = connections.parted_by(joints);
    if (parted.count == 0) continue;
    weights_.push_back(parted.weight_n_per_m);
    for (const Pair& pair : joints) of_pair_[pair].push_back(static_cast<int>(names_.size()));
    names_.push_back(name_of(solid, joints));
  }
}

std::vector<std::string> bent_joints(const Solid& solid) {
  const auto points = joint_points(solid);
  const double tolerance_m = straight * solid.size_m();
  const auto pairs = that_touch(points, tolerance_m);
  const Connections connections(solid, pairs);
  std::vector<std::string> names;
  for (const Pair& pair : pairs) {
    if (line_through(points.at(pair), Point::Zero(), tolerance_m)) continue;
    if (connections.parted_by({pair}).count > 0) names.push_back(name_of(solid, {pair}));
  }
  return names;
}

std::vector<std::set<Pair>> Surfaces::joints() const {
  std::vector<std::set<Pair>> all(names_.size());
  for (const auto& [pair, surfaces] : of_pair_) {
    for (const int surface : surfaces) all[at(surface)].insert(pair);
  }
  return all;
}

const std::vector<int>& Surfaces::of(const std::pair<int, int>& pair) const {
  static const std::vector<int> none;
  const auto found = of_pair_.find(pair);
  return found == of_pair_.end() ? none : found->second;
}

}  // namespace blockweir::solid
