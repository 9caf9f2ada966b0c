// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/angular_momentum.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/step/touching_groups.hpp"

namespace blockweir::solid {

/// In the step, of the point of a block on which its forces turn it as if they acted there: the centroid, of a mesh's
/// triangle the point itself.
Point AngularMomentum::way(int block, const Point& material) const {
  const auto b = at(block);
  if (!model_.blocks[b].is_part()) return trial_.increment[b].head<2>();
  return trial_.placement[b].displacement(material) - state_.placements[b].displacement(material);
}

/// By what two blocks give each other, in the step [N s per metre of thickness and metre of arm].
double AngularMomentum::lost(const Interaction& action) const {
  const Point apart = way(action.block_i, action.at_i) - way(action.block_j, action.at_j);
  return trial_.dt / 2 * geometry::cross(apart, action.pull());
}

void AngularMomentum::restore(IslandEquations& s) {
  if (trial_.scheme.second_order() || !trial_.scheme.damps) return;
  const auto between_two = [this](const Interaction& a) {
    return trial_.moves(a.block_i) && trial_.moves(a.block_j) && !a.force.isZero(0);
  };
  if (std::none_of(s.actions.begin(), s.actions.end(), between_two)) return;
  const std::vector<int> group_of = touching_groups(step_, s);
  struct Group {
    bool anchored = false;
    double lost = 0;
    Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  };
  std::vector<Group> groups(group_of.size());
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    const Interaction& a = s.actions[k];
    if (k < s.island.contacts.size() && !touches(step_, s.island.contacts[k])) continue;
    const bool both = trial_.moves(a.block_i) && trial_.moves(a.block_j);
    Group& group = groups[at(group_of[at(s.local(trial_.moves(a.block_i) ? a.block_i : a.block_j))])];
    if (both) group.lost += lost(a);
    group.anchored = group.anchored || !both;
  }
  const auto turns = [](const Group& group) { return !group.anchored && group.lost != 0; };
  const auto rigid = [&](std::size_t k) {
    const auto b = at(s.island.blocks[k]);
    return rigid_motions(model_.blocks[b], trial_.placement[b],
                         trial_.placement[at(s.island.blocks[at(group_of[k])])].centre());
  };
  for (std::size_t k = 0; k < group_of.size(); ++k) {
    Group& group = groups[at(group_of[k])];
    if (turns(group)) group.mass += rigid(k).transpose() * trial_.inertia(at(s.island.blocks[k])) * rigid(k);
  }
  for (Group& group : groups) {
    if (turns(group)) group.turn = group.mass.ldlt().solve(Eigen::Vector3d(0, 0, group.lost));
  }
  for (std::size_t k = 0; k < group_of.size(); ++k) {
    const Group& group = groups[at(group_of[k])];
    if (turns(group)) state_.blocks[at(s.island.blocks[k])].velocity += rigid(k) * group.turn;
  }
}

}  // namespace blockweir::solid
