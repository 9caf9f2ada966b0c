// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/determinacy.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/viscous_ground.hpp"

namespace blockweir::solid::limit {
namespace {

constexpr int ground = -1;  // all that it is made of

/// Faces of two bodies in one plane.
struct PlaneJoint {
  std::pair<int, int> bodies;
  std::vector<const Face*> faces;
};

bool in_one_plane(const Face& one, const Face& other, double tolerance_m) {
  return std::abs(geometry::cross(one.normal, other.normal)) < scene::rounding_ratio &&
         std::abs(one.normal.dot(other.from_m - one.from_m)) < tolerance_m;
}

bool is_ground(const scene::Scene& scene, int block) {
  return block >= 0 && (scene.blocks[at(block)].fixed || scene::rests_on_viscous_ground(scene, block));
}

std::vector<PlaneJoint> plane_joints(const scene::Scene& scene, const std::vector<Face>& faces) {
  const double tolerance_m = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  const auto body = [&](int block) { return is_ground(scene, block) ? ground : block; };
  std::vector<PlaneJoint> joints;
  std::multimap<std::pair<int, int>, std::size_t> of_bodies;
  for (const Face& face : faces) {
    const std::pair<int, int> bodies = std::minmax(body(face.a), body(face.b));
    if (bodies.first == bodies.second) continue;
    const auto [first, last] = of_bodies.equal_range(bodies);
    const auto same = std::find_if(first, last, [&](const auto& joint) {
      return in_one_plane(*joints[joint.second].faces.front(), face, tolerance_m);
    });
    if (same != last) {
      joints[same->second].faces.push_back(&face);
    } else {
      of_bodies.emplace(bodies, joints.size());
      joints.push_back({bodies, {&face}});
    }
  }
  return joints;
}

/// Blocks that joints lead to from the ground.
std::size_t standing(const std::vector<PlaneJoint>& joints) {
  std::set<int> reached = {ground};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& [bodies, faces] : joints) {
      if (reached.contains(bodies.first)) reached.insert(bodies.second);
      if (reached.contains(bodies.second)) reached.insert(bodies.first);
    }
  }
  return reached.size() - 1;
}

}  // namespace

bool each_joint_divides(const scene::Scene& scene, const std::vector<Face>& faces) {
  std::size_t can_move = 0;
  for (int b = 0; b < static_cast<int>(scene.blocks.size()); ++b) can_move += is_ground(scene, b) ? 0 : 1;
  const std::vector<PlaneJoint> joints = plane_joints(scene, faces);
  return joints.size() == can_move && standing(joints) == can_move;
}

bool share_a_loop(const scene::Scene& scene, const std::vector<Face>& faces,
                  const std::function<bool(const Face&)>& weak) {
  const std::vector<PlaneJoint> joints = plane_joints(scene, faces);
  // Blocks and joints are the nodes, the ground the first of them. Edges of one component lie in a loop.
  using Component = boost::property<boost::edge_index_t, std::size_t>;
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Component> graph;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::size_t node = 1 + scene.blocks.size() + j;
    for (const int body : {joints[j].bodies.first, joints[j].bodies.second}) add_edge(at(body + 1), node, graph);
  }
  const auto component = get(boost::edge_index, graph);
  biconnected_components(graph, component);
  std::set<std::size_t> with_a_weak_joint;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (std::none_of(joints[j].faces.begin(), joints[j].faces.end(), [&](const Face* f) { return weak(*f); })) continue;
    const auto [edge, last] = out_edges(1 + scene.blocks.size() + j, graph);
    const std::size_t one = component[*edge];
    if (one == component[*std::next(edge)] && !with_a_weak_joint.insert(one).second) return true;
  }
  return false;
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
