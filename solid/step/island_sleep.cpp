// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/island_sleep.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

bool IslandSleep::may_begin(const IslandEquations& s, const StepMode& mode) const {
  if (!model_.scene.analysis.sleep || mode.settles) return false;
  const double tolerance_n = formulation_->settings().force_tolerance_n;
  const auto rests = [&](int b) {
    return state_.sleep.rests(static_cast<std::size_t>(b), model_.blocks, trial_.external, tolerance_n);
  };
  const auto in_place = [&](int k) {
    const Support& support = state_.supports[static_cast<std::size_t>(k)];
    return support.held().cwiseProduct(support.separation).norm() <= formulation_->settings().penetration_tolerance_m;
  };
  const auto rests_on = [&](int k) {
    const ContactPoint& c = state_.contacts[static_cast<std::size_t>(k)];
    return rests(c.vertex_part) && rests(c.edge_part);
  };
  const auto hangs_still = [&](int k) {
    const auto& ends = state_.bolts[static_cast<std::size_t>(k)].part;
    return std::all_of(ends.begin(), ends.end(),
                       [&](int b) { return b < 0 ? !model_.base.moves_supports() : rests(b); });
  };
  return std::all_of(s.island.blocks.begin(), s.island.blocks.end(), rests) &&
         std::all_of(s.bolts.begin(), s.bolts.end(), hangs_still) &&
         std::all_of(s.island.supports.begin(), s.island.supports.end(), in_place) &&
         std::all_of(s.island.contacts.begin(), s.island.contacts.end(), rests_on);
}

void IslandSleep::begin(IslandEquations& s) {
  s.found = Found::asleep;
  ++counts_.slept_islands;
  for (const int block : s.island.blocks) {
    const auto b = static_cast<std::size_t>(block);
    trial_.go_to(b, Vector6::Zero());
    state_.blocks[b].velocity.setZero();
    state_.blocks[b].acceleration.setZero();
  }
}

}  // namespace blockweir::solid
