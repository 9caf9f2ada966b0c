// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of a step: what loads give goes into strain, springs and motion. Contacts and damping only take.
#include "solid/step/energy_balance.hpp"

#include "bridge/scene/at.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// What loads give an island's blocks in the step, less what strain, bolts and springs take up.
void Solid::balance_energy(IslandSystem& s, double dt) {
  const bool by_shi = !newmark_.second_order();
  const auto strained = [this](int b) { return increment_[at(b)].tail<3>(); };
  const auto strain = [this](int b) { return states_[at(b)].displacement.tail<3>(); };
  for (const int block : s.island.blocks) {
    const auto b = at(block);
    const Vector6 load = energy_balance_.through_step(b, external_[b], by_shi);
    const double work = blocks_[b].is_part() ? at_corners(b, load).dot(corner_increment(b)) : load.dot(increment_[b]);
    energy_balance_.give(work - loads_.constant(b).dot(increment_[b]));
    for_motion_[b] = work - strained(block).dot(blocks_[b].stiffness * (strain(block) + strained(block) / 2));
  }
  for (const int k : s.couplings) {
    const StrainCoupling& c = parts_.couplings[at(k)];
    for_motion_[at(c.i)] -= strained(c.i).dot(c.stiffness * (strain(c.j) + strained(c.j) / 2)) +
                            (strain(c.i) + strained(c.i) / 2).dot(c.stiffness * strained(c.j));
  }
  for (const int k : s.island.supports) {
    const Support& support = supports_[at(k)];
    const Point force = by_shi ? support.force : Point((formulation_->support_before(k).force + support.force) / 2);
    energy_balance_.give(force.dot(support.target(end_s_) - support.target(end_s_ - dt)));
  }
  const auto store = [&](const Interaction& action, double rise) {
    energy_balance_.store(rise);
    for_motion_[at(moves(action.block_i) ? action.block_i : action.block_j)] -= rise;
  };
  std::size_t next = 0;
  for (const int k : s.island.contacts) store(s.actions[next++], formulation_->stored(k, contacts_[at(k)]));
  for (const int k : s.island.supports) store(s.actions[next++], formulation_->stored(k, supports_[at(k)]));
  for (const int k : s.bolts) {
    const Bolt& bolt = bolts_[at(k)];
    const double tension = -s.actions[next].force.x();
    const double before = bolt.acting.tension_n_per_m;
    store(s.actions[next++], (tension - before) * (tension + before) / (2 * bolt.described->stiffness_n_per_m2));
  }
}

/// Of a base that moves.
Point Solid::push_of_base() const {
  Point push = Point::Zero();
  for (const IslandSystem& s : islands_) {
    if (s.asleep) continue;
    for (const Interaction& action : s.actions) {
      for (const bool second : {false, true}) {
        if (!moves(action.block(second))) push += (second ? 1 : -1) * action.pull();
      }
    }
  }
  return push;
}

}  // namespace blockweir::solid
