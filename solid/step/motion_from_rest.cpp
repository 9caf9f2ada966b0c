// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/motion_from_rest.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_flow.hpp"

namespace blockweir::solid {
namespace {

constexpr double still = 1e-6;               // of a fall through the step
constexpr std::ptrdiff_t most_blocks = 150;  // statics takes minutes for 400 that fall

}  // namespace

/// Are there so few that Newton's method follows their forces from step to step? Those of many are centred
/// (centred_forces.hpp), or statics would take too long.
bool MotionFromRest::follows_forces() const {
  if (!moves_by_itself() || !formulation_->holds_exactly() || !state_.bolts.empty()) return false;  // springs swing
  const auto strains = [](const Block& b) { return !b.fixed && !b.rigid; };
  return std::none_of(model_.blocks.begin(), model_.blocks.end(), strains) && 3 * moving_blocks() <= few_unknowns;
}

/// Not with its base or supports, and under water that does not answer within the step.
bool MotionFromRest::moves_by_itself() const {
  return model_.is(scene::AnalysisKind::dynamic) && !model_.scene.base_motion && state_.supports.empty() &&
         model_.boundary.empty() && !scene::flows_in_joints(model_.scene);
}

std::ptrdiff_t MotionFromRest::moving_blocks() const {
  return std::count_if(model_.blocks.begin(), model_.blocks.end(), [](const Block& b) { return !b.fixed; });
}

/// By forces: what is let go has none yet.
bool MotionFromRest::is_held() const {
  return std::any_of(state_.contacts.begin(), state_.contacts.end(),
                     [](const ContactPoint& c) { return !c.force.isZero(0); });
}

bool MotionFromRest::starts_at_rest(const std::vector<Panel>& water) {
  if (!moves_by_itself() || moving_blocks() > most_blocks) return false;
  const auto is_thrown = [](const BlockState& b) { return !b.velocity.isZero(0); };
  if (std::any_of(state_.blocks.begin(), state_.blocks.end(), is_thrown)) return false;
  before_ = state_;
  balance_before_ = state_.energy;
  if (rests_by_statics(water, model_.settling_time_s(), at_start)) return true;
  state_.restore(before_);
  state_.energy = balance_before_;
  return false;
}

void MotionFromRest::begin_step(double dt) {
  const double fall_m_per_s = model_.scene.analysis.gravity_m_per_s2 * dt;
  if (!follows_) follows_ = follows_forces();
  rested_ = *follows_ && !state_.guard.acts() && state_.fastest_m_per_s() <= still * fall_m_per_s && is_held();
  if (!rested_) return;
  before_ = state_;
  balance_before_ = state_.energy;
}

void MotionFromRest::end_step(double dt, const std::vector<Panel>& water, double at_s) {
  const double fall_m_per_s = model_.scene.analysis.gravity_m_per_s2 * dt;
  const double now_m_per_s = state_.fastest_m_per_s();
  const bool falls = now_m_per_s >= fall_m_per_s;  // held by nothing
  if (!rested_ || falls || now_m_per_s <= still * fall_m_per_s) return;
  const Standing moving = state_;
  const EnergyBalance balance = state_.energy;
  if (rests_by_statics(water, at_s, on_the_way)) {
    state_.smooth_steps = 0;
    return;
  }
  state_.restore(moving);
  state_.energy = balance;
}

bool MotionFromRest::rests_by_statics(const std::vector<Panel>& water, double at_s, const Search& search) {
  const long steps = counts_.steps;
  const Rest rest = state_.rest;
  const auto tried = std::pair(state_.whole_law, state_.lagging);
  state_.restore(before_);
  state_.energy.undo_work_since(balance_before_);
  statics_.come_to_rest(water, at_s, search.most_steps);
  counts_.steps = steps;
  std::tie(state_.whole_law, state_.lagging) = tried;
  if (!std::exchange(state_.rest, rest).found) return false;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    const Vector6 moved = state_.blocks[b].displacement - before_.blocks[b].displacement;
    const double farthest_m = moved.head<2>().norm() + model_.blocks[b].radius * std::abs(moved[2]);
    if (farthest_m > search.farthest * model_.scene.analysis.failure_displacement_m) return false;
  }
  return true;
}

}  // namespace blockweir::solid
