// SPDX-License-Identifier: GPL-3.0-or-later
// Spurious energy of a step, and its removal.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "bridge/scene/at.hpp"
#include "solid/step/step_energy.hpp"
#include "solid/step/touching_groups.hpp"

namespace blockweir::solid {

/// Blocks that touch each other in the step, or that bolts or a mesh join.
struct StepEnergy::Group {
  bool held = false;        ///< by contacts that a bond holds shut, bolts, or hinges of a smooth step
  bool may_let_go = false;  ///< has a contact that no bond holds shut
  bool anchored = false;    ///< to what does not move
  bool held_apart = false;  ///< by more than supports that go alike
  std::array<std::optional<double>, 2> led_m_per_s;  ///< along each axis, by supports
  double made = 0;                                   ///< kinetic energy beyond what there was for motion [J per metre]
  double round_off = 0;
  double kinetic = 0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< and angular momentum
  Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
  Eigen::Vector3d together = Eigen::Vector3d::Zero();  ///< rigid motion with these momenta, where nothing anchors it
  Eigen::Vector3d kept = Eigen::Vector3d::Zero();      ///< of it
  double left = 1;                                     ///< of all other motion
  double owed = 0;                                     ///< what there was not [J per metre]

  /// What only springs and hinges hold moves as its integrator has it.
  [[nodiscard]] bool watched() const { return may_let_go || !held; }
  [[nodiscard]] bool gives() const { return left != 1 || kept != together; }

  /// From motion within the group; then from its spin: forces act where the step ends, and keep angular momentum but to
  /// the order of the step.
  void settle() {
    constexpr double most_spin = 1e-2;  // in a step
    if (!watched() || made <= round_off) return;
    if (!anchored) kept = together = mass.ldlt().solve(momentum);
    const double within = std::max(0.0, kinetic - together.dot(momentum) / 2);
    if (within > 0) left = std::sqrt(std::max(0.0, 1 - made / within));
    owed = std::max(0.0, made - within);
    if (anchored || !may_let_go || owed == 0) return;
    const Eigen::Vector3d carried(momentum[0] / mass(0, 0), momentum[1] / mass(1, 1), 0);
    const double spin = (together.dot(momentum) - carried.dot(momentum)) / 2;
    if (!(spin > 0)) return;
    const double given = std::min(owed, most_spin * spin);
    kept = carried + std::sqrt(1 - given / spin) * (together - carried);
    owed -= given;
  }
};

StepEnergy::Made StepEnergy::made_by(std::size_t b) const {
  constexpr double round_off = 1e-12;
  const double force_n = formulation_->settings().force_tolerance_n;
  const Matrix6 M = trial_.inertia(b);
  const Vector6& v = state_.blocks[b].velocity;
  const Vector6& began = trial_.began_with[b];
  const double ends = v.dot(M * v);
  const double moved_m =
      trial_.increment[b].head<2>().norm() + model_.blocks[b].radius * trial_.increment[b].tail<4>().norm();
  return {(v - began).dot(M * (v + began)) / 2 - trial_.for_motion[b] + state_.energy.owed(b),
          round_off * (ends + began.dot(M * began) + std::abs(trial_.for_motion[b])) + force_n * moved_m};
}

/// What holds each group, or may let it go.
void StepEnergy::look_at_links(const IslandEquations& s, const std::vector<int>& group_of,
                               std::vector<Group>& groups) const {
  const auto group_with = [&](int block) -> Group& { return groups[at(group_of[at(s.local(block))])]; };
  enum class By { may_let_go, spring, hinge };
  const auto look = [&](const Interaction& a, By by) {
    for (const int block : {a.block_i, a.block_j}) {
      if (!trial_.moves(block)) continue;
      Group& group = group_with(block);
      group.may_let_go = group.may_let_go || by == By::may_let_go;
      // With Shi's scheme a block on a hinge gains energy as a toppling block does.
      group.held = group.held || by == By::spring || (by == By::hinge && trial_.scheme.second_order());
      if (trial_.moves(a.block_i) && trial_.moves(a.block_j)) continue;
      group.anchored = true;
      group.held_apart = group.held_apart || by != By::hinge;
    }
  };
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    if (k >= s.island.contacts.size()) {
      look(s.actions[k], k < s.actions.size() - s.bolts.size() ? By::hinge : By::spring);
    } else if (const int i = s.island.contacts[k]; touches(step_, i)) {
      const ContactPoint& c = state_.contacts[at(i)];
      look(s.actions[k], model_.laws.strength(c, c.force.x()).tension == 0 ? By::may_let_go : By::spring);
    }
  }
  for (const int k : s.island.supports) {
    const Support& support = state_.supports[at(k)];
    if (!trial_.moves(support.block)) continue;
    Group& group = group_with(support.block);
    const Point rate = support.target_rate(trial_.end_s, trial_.dt);
    for (const Eigen::Index axis : {0, 1}) {
      if (support.held()[axis] == 0) continue;
      std::optional<double>& led = group.led_m_per_s[at(axis)];
      if (led && *led != rate[axis]) group.held_apart = true;
      led = rate[axis];
    }
  }
}

/// Velocity of what holds the group, where that goes alike.
Point StepEnergy::carrier_of(const Group& group) const {
  const Point base = model_.base.velocity(trial_.end_s);
  if (group.held_apart) return base;
  return base + Point(group.led_m_per_s[0].value_or(0), group.led_m_per_s[1].value_or(0));
}

/// About the group's first block, so that sums do not depend on the rest of the island.
Eigen::Matrix<double, 6, 3> StepEnergy::rigid_of(const IslandEquations& s, const std::vector<int>& group_of,
                                                 std::size_t k) const {
  const auto b = at(s.island.blocks[k]);
  return rigid_motions(model_.blocks[b], trial_.placement[b],
                       trial_.placement[at(s.island.blocks[at(group_of[k])])].centre());
}

/// None where no block has made any.
std::vector<StepEnergy::Group> StepEnergy::makers(const IslandEquations& s, std::vector<int>& group_of) const {
  if (!trial_.scheme.damps) return {};
  const auto has_made = [&](int b) {
    const Made made = made_by(at(b));
    return state_.energy.owed(at(b)) > 0 || made.energy > made.round_off;
  };
  if (std::none_of(s.island.blocks.begin(), s.island.blocks.end(), has_made)) return {};
  group_of = touching_groups(step_, s);
  std::vector<Group> groups(group_of.size());
  look_at_links(s, group_of, groups);
  for (std::size_t k = 0; k < group_of.size(); ++k) {
    Group& group = groups[at(group_of[k])];
    if (!group.watched()) continue;
    const auto b = at(s.island.blocks[k]);
    const Made made = made_by(b);
    const Matrix6 M = trial_.inertia(b);
    const Vector6 own = state_.blocks[b].velocity - going_at(b, carrier_of(group));
    group.made += made.energy;
    group.kinetic += own.dot(M * own) / 2;
    group.round_off += made.round_off;
    if (group.anchored) continue;
    const Eigen::Matrix<double, 6, 3> rigid = rigid_of(s, group_of, k);
    group.momentum += rigid.transpose() * (M * own);
    group.mass += rigid.transpose() * M * rigid;
  }
  for (Group& group : groups) group.settle();
  return groups;
}

bool StepEnergy::affords(const IslandEquations& s) const {
  constexpr double much = 1e-2;  // of the motion: less is the integrator's own error
  std::vector<int> group_of;
  const std::vector<Group> groups = makers(s, group_of);
  return std::all_of(groups.begin(), groups.end(),
                     [](const Group& group) { return !group.may_let_go || group.owed <= much * group.kinetic; });
}

/// What moves and has pushed what stands pays for that: it has something to pay with.
void StepEnergy::pass_debts_on(const IslandEquations& s, const std::vector<int>& group_of,
                               std::vector<Group>& groups) const {
  std::vector<Group*> payer(groups.size(), nullptr);
  for (const int k : s.island.contacts) {
    const ContactPoint& c = state_.contacts[at(k)];
    if (c.gap > formulation_->settings().lasting_overlap_m) continue;
    if (!trial_.moves(c.vertex_part) || !trial_.moves(c.edge_part)) continue;
    const int a = group_of[at(s.local(c.vertex_part))];
    const int b = group_of[at(s.local(c.edge_part))];
    if (a == b) continue;
    for (const auto& [owes, pays] : {std::pair(a, b), std::pair(b, a)}) {
      Group& other = groups[at(pays)];
      const Group& group = groups[at(owes)];
      if (group.owed == 0 || other.owed > 0 || !other.watched() || other.kinetic <= group.kinetic) continue;
      Group*& best = payer[at(owes)];
      if (best == nullptr || other.kinetic > best->kinetic) best = &other;
    }
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (payer[g] == nullptr) continue;
    payer[g]->made += std::exchange(groups[g].owed, 0.0);
    payer[g]->settle();
  }
}

void StepEnergy::take_back(IslandEquations& s) {
  std::vector<int> group_of;
  std::vector<Group> groups = makers(s, group_of);
  if (groups.empty()) return;
  pass_debts_on(s, group_of, groups);
  for (std::size_t k = 0; k < group_of.size(); ++k) {
    const Group& group = groups[at(group_of[k])];
    const auto b = at(s.island.blocks[k]);
    if (group.watched()) state_.energy.owe(b, at(group_of[k]) == k ? group.owed : 0, model_.blocks.size());
    if (!group.gives()) continue;
    const Eigen::Matrix<double, 6, 3> rigid = rigid_of(s, group_of, k);
    Vector6& velocity = state_.blocks[b].velocity;
    const Vector6 before = velocity;
    const Point carrier = carrier_of(group);
    const Vector6 own = velocity - going_at(b, carrier);
    velocity += rigid * group.kept + group.left * (own - rigid * group.together) - own;
    give_by_carrier(b, carrier, before);
  }
}

}  // namespace blockweir::solid
