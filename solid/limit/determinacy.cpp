// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/determinacy.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::solid::limit {
namespace {

constexpr int ground = -1;  // all fixed blocks

using Joints = std::map<std::pair<int, int>, const Face*>;  // the first face of each pair

bool in_one_plane(const Face& one, const Face& other, double tolerance_m) {
  return std::abs(geometry::cross(one.normal, other.normal)) < scene::rounding_ratio &&
         std::abs(one.normal.dot(other.from_m - one.from_m)) < tolerance_m;
}

/// Blocks that joints lead to from the ground.
std::size_t standing(const Joints& joints) {
  std::set<int> reached = {ground};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& [pair, face] : joints) {
      if (reached.contains(pair.first)) reached.insert(pair.second);
      if (reached.contains(pair.second)) reached.insert(pair.first);
    }
  }
  return reached.size() - 1;
}

}  // namespace

bool follow_from_equilibrium(const scene::Scene& scene, const std::vector<Face>& faces, const std::vector<Tie>& ties) {
  if (!ties.empty()) return false;
  const double tolerance_m = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  const auto body = [&](int block) { return scene.blocks[at(block)].fixed ? ground : block; };
  Joints joints;
  for (const Face& face : faces) {
    if (face.cohesion_n_per_m > 0 || face.tension_n_per_m > 0) return false;
    const auto [first, is_new] = joints.emplace(std::minmax(body(face.a), body(face.b)), &face);
    if (!is_new && !in_one_plane(*first->second, face, tolerance_m)) return false;
  }
  const auto can_move = static_cast<std::size_t>(
      std::count_if(scene.blocks.begin(), scene.blocks.end(), [](const scene::Block& b) { return !b.fixed; }));
  return joints.size() == can_move && standing(joints) == can_move;
}

}  // namespace blockweir::solid::limit
