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
#include "bridge/scene/viscous_ground.hpp"

namespace blockweir::solid::limit {
namespace {

constexpr int ground = -1;  // all that it is made of

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

bool is_ground(const scene::Scene& scene, int block) {
  return block >= 0 && (scene.blocks[at(block)].fixed || scene::rests_on_viscous_ground(scene, block));
}

}  // namespace

bool each_joint_divides(const scene::Scene& scene, const std::vector<Face>& faces) {
  const double tolerance_m = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  const auto body = [&](int block) { return is_ground(scene, block) ? ground : block; };
  Joints joints;
  for (const Face& face : faces) {
    if (is_ground(scene, face.a) && is_ground(scene, face.b)) continue;
    const auto [first, is_new] = joints.emplace(std::minmax(body(face.a), body(face.b)), &face);
    if (!is_new && !in_one_plane(*first->second, face, tolerance_m)) return false;
  }
  std::size_t can_move = 0;
  for (int b = 0; b < static_cast<int>(scene.blocks.size()); ++b) can_move += is_ground(scene, b) ? 0 : 1;
  return joints.size() == can_move && standing(joints) == can_move;
}

bool follow_from_equilibrium(const scene::Scene& scene, const std::vector<Face>& faces, const std::vector<Tie>& ties) {
  const auto holds_ground = [&](const Tie& tie) { return tie.b < 0 && is_ground(scene, tie.a); };
  const auto bonds = [&](const Face& face) {
    const bool within_ground = is_ground(scene, face.a) && is_ground(scene, face.b);
    return !within_ground && (face.cohesion_n_per_m > 0 || face.tension_n_per_m > 0);
  };
  return std::all_of(ties.begin(), ties.end(), holds_ground) && std::none_of(faces.begin(), faces.end(), bonds) &&
         each_joint_divides(scene, faces);
}

}  // namespace blockweir::solid::limit
