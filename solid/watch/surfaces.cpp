// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "bridge/scene/viscous_ground.hpp"
#include "solid/watch/joint_lines.hpp"
#include "solid/watch/joint_name.hpp"

namespace blockweir::solid {
namespace {

using Pair = BlockPair;

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
std::vector<Pair> that_touch(const Solid& solid, const JointPoints& points) {
  std::vector<Pair> pairs;
  for (const auto& [pair, at_points] : points) {
    if (!is_point(solid, at_points)) pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

Surfaces::Surfaces(const Solid& solid) {
  const JointPoints points = joint_points(solid);
  const std::vector<Pair> pairs = that_touch(solid, points);
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
    if (is_straight(solid, points.at(pair))) candidates.push_back({pair});
  }
  for (const std::set<Pair>& joints : candidates) {
    const Connections::Reach parted = connections.parted_by(joints);
    if (parted.count == 0) continue;
    add(joints, name_of(solid, joints), parted.weight_n_per_m);
  }
}

void Surfaces::add(const std::set<Pair>& joints, const std::string& name, double weight_n_per_m) {
  for (const Pair& pair : joints) of_pair_[pair].push_back(static_cast<int>(names_.size()));
  names_.push_back(name);
  weights_.push_back(weight_n_per_m);
}

Surfaces Surfaces::parts(const Solid& solid, const std::vector<std::string>& names) {
  constexpr std::size_t most_planes = 4;  // more are a network, whose sums say nothing
  const JointPoints points = joint_points(solid);
  const std::vector<std::set<Pair>> whole = Surfaces(solid).joints();
  Surfaces parts;
  for (const std::string& name : names) {
    JointPoints own;
    for (const auto& [pair, at_points] : points) {
      const bool counts = joint_set(solid, pair.first, pair.second) == name && is_straight(solid, at_points);
      if (counts) own[pair] = at_points;
    }
    std::vector<std::set<Pair>> planes = in_one_line(solid, own);
    for (const auto& [pair, at_points] : own) {
      const auto has_it = [&p = pair](const std::set<Pair>& plane) { return plane.contains(p); };
      if (std::none_of(planes.begin(), planes.end(), has_it)) planes.push_back({pair});
    }
    if (planes.size() > most_planes) continue;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (std::find(whole.begin(), whole.end(), planes[i]) != whole.end()) continue;
      parts.add(planes[i], planes.size() == 1 ? name : fmt::format("{} ({} of {})", name, i + 1, planes.size()), 0);
    }
  }
  return parts;
}

std::vector<std::string> bent_joints(const Solid& solid) {
  const auto points = joint_points(solid);
  const auto pairs = that_touch(solid, points);
  const Connections connections(solid, pairs);
  std::vector<std::string> names;
  for (const Pair& pair : pairs) {
    if (is_straight(solid, points.at(pair))) continue;
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
