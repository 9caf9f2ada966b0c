// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/joint_laws.hpp"

#include <map>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"
#include "solid/contact/neighbours.hpp"

namespace blockweir::solid {
JointLaws::JointLaws(const scene::Scene& scene) {
  laws_.emplace_back(scene.default_joint, -1);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const auto& joint = scene.joints[j];
    by_pair_[key(joint.between[0], joint.between[1])] = static_cast<int>(laws_.size());
    laws_.emplace_back(joint.law, static_cast<int>(j));
  }
  planes_.assign(laws_.size(), 0);
  add_planes(scene);
}

int JointLaws::add_plane(int own) {
  const JointProperties law = (*this)[own].of_plane();
  const auto same = [&](const JointProperties& other) {
    return other.joint == -1 && !other.bonds() && other.slides_as(law);
  };
  const auto known = std::find_if(laws_.begin() + 1, laws_.end(), same);
  const auto plane = static_cast<int>(known - laws_.begin());
  if (known == laws_.end()) laws_.push_back(law);
  return planes_[at(own)] = plane;
}

void JointLaws::add_planes(const scene::Scene& scene) {
  const double touching_m = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const auto [a, b] = scene.joints[j].between;
    const scene::JointTrace trace = scene::trace_joint(scene.blocks[at(a)], scene.blocks[at(b)], touching_m);
    if (trace.pieces.empty()) continue;
    const int own = static_cast<int>(j) + 1;
    const int plane = add_plane(own);
    for (const scene::TracePiece& p : trace.pieces) {
      on_planes_[a].push_back({p.edge_a, std::min(p.s_from_a, p.s_to_a), std::max(p.s_from_a, p.s_to_a), plane, own});
      on_planes_[b].push_back({p.edge_b, std::min(p.s_from_b, p.s_to_b), std::max(p.s_from_b, p.s_to_b), plane, own});
    }
  }
  if (any_plane()) add_neighbours_of_planes(scene, touching_m);
}

/// Blocks that touch, and whose joint the scene does not state, have its default law however they move.
void JointLaws::add_neighbours_of_planes(const scene::Scene& scene, double touching_m) {
  std::vector<Box> boxes;
  std::vector<bool> movable;
  for (const scene::Block& block : scene.blocks) {
    const geometry::Bounds bounds = geometry::bounds_of(block.vertices);
    boxes.emplace_back(bounds.low.array() - touching_m, bounds.high.array() + touching_m);
    movable.push_back(!block.fixed);
  }
  for (const auto& [a, b] : neighbours(boxes, movable)) {
    const bool stated = by_pair_.contains(key(a, b));
    if (stated || (!on_planes_.contains(a) && !on_planes_.contains(b))) continue;
    if (!scene::trace_joint(scene.blocks[at(a)], scene.blocks[at(b)], touching_m).pieces.empty()) {
      by_pair_[key(a, b)] = 0;
    }
  }
}

int JointLaws::of_contact(int vertex_block, int face_plane, const Edge& on) const {
  const auto own = by_pair_.find(key(vertex_block, on.block));
  if (own == by_pair_.end()) {
    if (on.plane != face_plane && !on.in_line) return 0;
    return on.plane != 0 ? on.plane : face_plane;
  }
  if (own->second == 0 || on.plane == 0 || on.plane != face_plane) return own->second;
  const auto& pieces = on_planes_.at(on.block);
  const bool own_joint_lies_here = std::any_of(pieces.begin(), pieces.end(), [&](const OnPlane& piece) {
    return piece.edge == on.edge && piece.joint_law == own->second;
  });
  return own_joint_lies_here || on.plane == planes_[at(own->second)] ? own->second : on.plane;
}

int JointLaws::plane_of(int block, int edge, double s_from, double s_to) const {
  const auto pieces = on_planes_.find(block);
  if (pieces == on_planes_.end()) return 0;
  std::map<int, double> covered;
  for (const OnPlane& piece : pieces->second) {
    if (piece.edge == edge) {
      covered[piece.plane] += std::max(0.0, std::min(s_to, piece.s_to) - std::max(s_from, piece.s_from));
    }
  }
  const auto most = std::max_element(covered.begin(), covered.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most != covered.end() && most->second > (s_to - s_from) / 2 ? most->first : 0;
}

}  // namespace blockweir::solid
