// SPDX-License-Identifier: GPL-3.0-or-later
// What a step has made of nothing is taken back from the velocities. Contact forces act along the directions of the
// step's end, and points turn on their way there: a block that topples would gain by an error of the step's first
// order.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "bridge/scene/at.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {
namespace {

/// Blocks that touch each other in the step, or that bolts or a mesh join.
struct Group {
  bool held = false;        ///< by contacts that a bond holds shut, bolts or supports: springs and hinges
  bool may_let_go = false;  ///< has a contact that no bond holds shut
  bool anchored = false;    ///< to what does not move
  bool led = false;         ///< by supports, whose work is not among the loads'
  double made = 0;          ///< kinetic energy beyond what there was for motion [J per metre]
  double round_off = 0;
  double kinetic = 0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< and angular momentum
  Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
  Eigen::Vector3d together = Eigen::Vector3d::Zero();  ///< rigid motion with these momenta, where nothing anchors it
  double left = 1;                                     ///< of all other motion
  double owed = 0;                                     ///< what that motion had not [J per metre]

  /// What only springs and hinges hold moves as its integrator has it.
  [[nodiscard]] bool watched() const { return !led && (may_let_go || !held); }
  void settle() {
    if (!watched() || made <= round_off) return;
    if (!anchored) together = mass.ldlt().solve(momentum);
    const double within = kinetic - together.dot(momentum) / 2;
    if (within > 0) left = std::sqrt(std::max(0.0, 1 - made / within));
    owed = std::max(0.0, made - std::max(0.0, within));
  }
};

/// Columns: rates of a block, as its state has them, that moves with (x, y) and turns about a point.
Eigen::Matrix<double, 6, 3> rigid_motions(const Block& block, const Placement& placement, const Point& about) {
  Eigen::Matrix<double, 6, 3> motions = Eigen::Matrix<double, 6, 3>::Zero();
  const auto place = [&](Eigen::Index row, const Point& p) {
    motions.block<2, 2>(row, 0).setIdentity();
    motions.block<2, 1>(row, 2) = perpendicular(p - about);
  };
  if (block.is_part()) {
    for (int i = 0; i < 3; ++i) place(2 * i, placement.position(block.vertices[at(i)]));
  } else {
    place(0, placement.centre());
    motions(2, 2) = 1;
  }
  return motions;
}

}  // namespace

/// Of each of an island's blocks, by the first in it.
std::vector<int> Solid::groups_of(const IslandSystem& s) const {
  std::vector<int> lower(s.island.blocks.size());
  std::iota(lower.begin(), lower.end(), 0);
  const auto lowest = [&](int k) {
    while (lower[at(k)] != k) k = lower[at(k)] = lower[at(lower[at(k)])];
    return k;
  };
  const auto join = [&](int a, int b) {
    if (!moves(a) || !moves(b)) return;
    const int i = lowest(local_[at(a)]);
    const int j = lowest(local_[at(b)]);
    lower[at(std::max(i, j))] = std::min(i, j);
  };
  for (const int k : s.island.contacts) {
    if (touches(k)) join(contacts_[at(k)].vertex_part, contacts_[at(k)].edge_part);
  }
  for (const int k : s.bolts) join(bolts_[at(k)].part[0], bolts_[at(k)].part[1]);
  for (const int k : s.couplings) join(parts_.couplings[at(k)].i, parts_.couplings[at(k)].j);
  for (int k = 0; k < static_cast<int>(lower.size()); ++k) lower[at(k)] = lowest(k);
  return lower;
}

/// Is a contact closed as the step begins or as it ends?
bool Solid::touches(int contact) const {
  return contacts_[at(contact)].state != ContactState::open ||
         formulation_->before(contact).state != ContactState::open;
}

/// Where nothing anchors a group its momenta stay. Most steps make nothing: then nothing is grouped.
void Solid::take_back_energy(IslandSystem& s, const StepMode& mode) {
  if (mode.settles || !newmark_.damps || base_.moves_supports() || !mean_motions_.empty()) return;
  constexpr double round_off = 1e-12;
  const double force_n = formulation_->settings().force_tolerance_n;
  struct Made {
    double energy = 0;  ///< what a block's motion has gained beyond what there was for it [J per metre]
    double round_off = 0;
    double kinetic = 0;
  };
  const auto made_by = [&](std::size_t b) -> Made {
    const Matrix6 M = inertia(b);
    const Vector6& v = states_[b].velocity;
    const Vector6& began = began_with_[b];
    const double ends = v.dot(M * v);
    const double moved_m = increment_[b].head<2>().norm() + blocks_[b].radius * increment_[b].tail<4>().norm();
    return {(v - began).dot(M * (v + began)) / 2 - for_motion_[b] + energy_balance_.owed(b),
            round_off * (ends + began.dot(M * began) + std::abs(for_motion_[b])) + force_n * moved_m, ends / 2};
  };
  const auto has_made = [&](int b) {
    const Made made = made_by(at(b));
    return energy_balance_.owed(at(b)) > 0 || made.energy > made.round_off;
  };
  if (std::none_of(s.island.blocks.begin(), s.island.blocks.end(), has_made)) return;
  const std::vector<int> group_of = groups_of(s);
  std::vector<Group> groups(group_of.size());
  const auto group_with = [&](int block) -> Group& { return groups[at(group_of[at(local_[at(block)])])]; };
  const auto look = [&](const Interaction& a, bool may_let_go) {
    for (const int block : {a.block_i, a.block_j}) {
      if (!moves(block)) continue;
      Group& group = group_with(block);
      (may_let_go ? group.may_let_go : group.held) = true;
      if (!moves(a.block_i) || !moves(a.block_j)) group.anchored = true;
    }
  };
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    if (k >= s.island.contacts.size()) {
      look(s.actions[k], false);
    } else if (const int i = s.island.contacts[k]; touches(i)) {
      const ContactPoint& c = contacts_[at(i)];
      look(s.actions[k], laws_[c.law].strength(c.bond, c.bond_length).tension == 0);
    }
  }
  for (const int k : s.island.supports) {
    const Support& support = supports_[at(k)];
    if (moves(support.block) && !support.target_rate(end_s_, matrices_dt_).isZero(0)) {
      group_with(support.block).led = true;
    }
  }
  // About the group's first block, so that sums do not depend on what else the island has.
  const auto rigid_of = [&](std::size_t k) {
    const auto b = at(s.island.blocks[k]);
    return rigid_motions(blocks_[b], placement_[b], placement_[at(s.island.blocks[at(group_of[k])])].centre());
  };
  for (std::size_t k = 0; k < group_of.size(); ++k) {
    Group& group = groups[at(group_of[k])];
    if (!group.watched()) continue;
    const auto b = at(s.island.blocks[k]);
    const Made made = made_by(b);
    group.made += made.energy;
    group.kinetic += made.kinetic;
    group.round_off += made.round_off;
    if (group.anchored) continue;
    const Eigen::Matrix<double, 6, 3> rigid = rigid_of(k);
    const Matrix6 M = inertia(b);
    group.momentum += rigid.transpose() * (M * states_[b].velocity);
    group.mass += rigid.transpose() * M * rigid;
  }
  for (Group& group : groups) group.settle();
  for (std::size_t k = 0; k < group_of.size(); ++k) {
    const Group& group = groups[at(group_of[k])];
    const auto b = at(s.island.blocks[k]);
    if (group.watched()) energy_balance_.owe(b, at(group_of[k]) == k ? group.owed : 0, blocks_.size());
    if (group.left == 1) continue;
    const Vector6 carried = rigid_of(k) * group.together;
    states_[b].velocity = carried + group.left * (states_[b].velocity - carried);
  }
}

}  // namespace blockweir::solid
