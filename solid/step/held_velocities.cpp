// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/held_velocities.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

void HeldVelocities::settle(IslandEquations& s, double dt) {
  s.found == Found::by_sweeps ? settle_swept(s, dt) : settle_solved(s, dt);
}

void HeldVelocities::settle_solved(IslandEquations& s, double dt) {
  constexpr double unheard_m_per_s = 1e-9;
  const auto rests = [this](int b) {
    return trial_.increment[at(b)].isZero(0) && state_.blocks[at(b)].velocity.isZero(0);
  };
  if (!model_.base.moves_supports() && std::all_of(s.island.blocks.begin(), s.island.blocks.end(), rests)) return;
  const auto lacks = [&](const Interaction& a, bool second) -> Eigen::Vector2d {
    if (a.block(second) < 0) return Eigen::Vector2d::Zero();
    const auto b = at(a.block(second));
    const Vector6 mean = to_mean() ? Vector6(trial_.increment[b] / dt) : Vector6(Vector6::Zero());
    return a.shape(trial_.placement[b], second) *
           (mean - trial_.rate(b, trial_.placement[b], state_.blocks[b].velocity));
  };
  double loudest = 0;
  std::vector<Eigen::Vector2d> missing(s.actions.size(), Eigen::Vector2d::Zero());
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    const Interaction& a = s.actions[k];
    if (a.held.isZero(0)) continue;
    Eigen::Vector2d m = lacks(a, false) - lacks(a, true);
    if (!to_mean()) m += led_rate(s, k, dt);
    missing[k] = a.held_stiffness(opening_slope(s, k)) * m;
    const Eigen::Vector2d along(m.x() - opening_slope(s, k) * m.y(), m.y());
    for (int axis = 0; axis < 2; ++axis) {
      if (a.held[axis] > 0) loudest = std::max(loudest, std::abs(along[axis]));
    }
  }
  if (loudest > unheard_m_per_s) project(s, missing);
}

/// `missing`: of each action, weighted by what holds.
void HeldVelocities::project(IslandEquations& s, const std::vector<Eigen::Vector2d>& missing) {
  s.set_block_matrices();
  s.residual.setZero();
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    Interaction& a = s.actions[k];
    a.stiffness = a.held_stiffness(opening_slope(s, k));
    s.add_stiffness(a);
    a.force = missing[k];
    for (const bool second : {false, true}) {
      if (!trial_.moves(a.block(second))) continue;
      const auto b = at(a.block(second));
      const Vector6 push = trial_.placement[b].generalized((second ? -1 : 1) * a.pull(), a.at(second));
      s.unknowns->add(s.local(static_cast<int>(b)), push, s.residual);
    }
  }
  if (!s.solve(/*symmetric=*/true)) return;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    state_.blocks[at(s.island.blocks[k])].velocity += s.unknowns->take_own(static_cast<int>(k), s.correction);
  }
}

/// What an action's end on a moving base adds to its gap and slip in a second, beyond the step's mean.
Eigen::Vector2d HeldVelocities::rate_of_fixed(const Interaction& action, double dt) const {
  Eigen::Vector2d rate = Eigen::Vector2d::Zero();
  for (const bool second : {false, true}) {
    const int block = action.block(second);
    if (block < 0 || trial_.moves(block)) continue;
    Vector6 beyond = state_.blocks[at(block)].velocity;
    if (to_mean()) beyond -= trial_.increment[at(block)] / dt;
    rate += (second ? -1 : 1) * (action.shape(trial_.placement[at(block)], second) * beyond);
  }
  return rate;
}

/// Velocities along held directions become those of what holds them, as settle_solved() has it.
void HeldVelocities::settle_swept(IslandEquations& s, double dt) {
  constexpr int most = 20;
  constexpr double unheard_m_per_s = 1e-9;
  Eigen::VectorXd& beyond = s.correction;  // what velocities have beyond those that are due
  beyond.setZero();
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    const auto b = at(s.island.blocks[k]);
    Vector6 rate = state_.blocks[b].velocity;
    if (to_mean()) rate -= (model_.blocks[b].is_part() ? trial_.corner_increment(b) : trial_.increment[b]) / dt;
    const auto& numbers = s.unknowns->of(static_cast<int>(k));
    for (std::size_t i = 0; i < numbers.size(); ++i) beyond[numbers[i]] = rate[static_cast<Eigen::Index>(i)];
  }
  const Eigen::VectorXd before = beyond;
  auto& rows = s.sweeps.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ForceSweeps::Row& row = rows[i];
    const bool held = !row.rule.opens || !row.force.isZero(0);
    const bool bolt = i >= s.actions.size() - s.bolts.size();
    const bool sticks = held && !row.slips;
    row.apart = rate_of_fixed(s.actions[i], dt);
    if (!to_mean() && i >= s.island.contacts.size() && !bolt) row.apart -= led_rate(s, i, dt);
    const double opening = i < s.island.contacts.size() ? opening_slope(s, i) : 0;
    row.rule = {.opens = false, .opening = {opening, opening}};
    row.rule.least_normal = -(row.rule.most_normal = held && !bolt ? ForceRule::unbounded : 0);
    row.rule.cohesion = sticks && !bolt ? ForceRule::unbounded : 0;
    row.force.setZero();
  }
  s.sweeps.displace(beyond);
  for (int sweep = 0; sweep < most && s.sweeps.sweep() > unheard_m_per_s; ++sweep) {
  }
  const Eigen::VectorXd change = s.sweeps.displacement() - before;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    state_.blocks[at(s.island.blocks[k])].velocity += s.unknowns->take_own(static_cast<int>(k), change);
  }
}

double HeldVelocities::opening_slope(const IslandEquations& s, std::size_t action) const {
  if (action >= s.island.contacts.size()) return 0;
  const int k = s.island.contacts[action];
  return formulation_->opening_slope(k, state_.contacts[at(k)]);
}

Point HeldVelocities::base_velocity(double dt) const {
  const BaseMotion& base = model_.base;
  if (!to_mean()) return base.velocity(trial_.end_s);
  return (base.displacement(trial_.end_s) - base.displacement(trial_.end_s - dt)) / dt;
}

Eigen::Vector2d HeldVelocities::led_rate(const IslandEquations& s, std::size_t action, double dt) const {
  const std::size_t contacts = s.island.contacts.size();
  if (action < contacts) return Eigen::Vector2d::Zero();
  return state_.supports[at(s.island.supports[action - contacts])].target_rate(trial_.end_s, dt) +
         model_.base.velocity(trial_.end_s);
}

}  // namespace blockweir::solid
