// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/constrained_velocities.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bridge/scene/at.hpp"
#include "solid/step/sweep_rows.hpp"

namespace blockweir::solid {

void ConstrainedVelocities::settle(IslandEquations& s, double dt) {
  if (s.is_free()) return;
  if (s.found == Found::by_sweeps) return settle_by_impulses(s, dt);
  std::vector<Vector6> before;
  for (const int block : s.island.blocks) before.push_back(state_.blocks[at(block)].velocity);
  if (settle_solved(s, dt)) return;
  for (std::size_t k = 0; k < before.size(); ++k) state_.blocks[at(s.island.blocks[k])].velocity = before[k];
  set_rows(s);
  settle_by_impulses(s, dt);
}

/// False if friction cannot provide the impulses.
bool ConstrainedVelocities::settle_solved(IslandEquations& s, double dt) {
  constexpr double unheard_m_per_s = 1e-9;
  const auto rests = [this](int b) {
    return trial_.increment[at(b)].isZero(0) && state_.blocks[at(b)].velocity.isZero(0);
  };
  if (!model_.base.moves_supports() && std::all_of(s.island.blocks.begin(), s.island.blocks.end(), rests)) {
    return true;
  }
  const auto lacks = [&](const Interaction& a, bool second) -> Eigen::Vector2d {
    if (a.block(second) < 0) return Eigen::Vector2d::Zero();
    const auto b = at(a.block(second));
    return a.shape(trial_.placement[b], second) * -trial_.rate(b, trial_.placement[b], state_.blocks[b].velocity);
  };
  double loudest = 0;
  double landing = 0;  // faster than a fall through the step: an impact
  std::vector<Eigen::Vector2d> missing(s.actions.size(), Eigen::Vector2d::Zero());
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    const Interaction& a = s.actions[k];
    if (a.held.isZero(0)) continue;
    Eigen::Vector2d m = lacks(a, false) - lacks(a, true);
    m += led_rate(s, k, dt);
    missing[k] = a.held_stiffness(opening_slope(s, k)) * m;
    const Eigen::Vector2d along(m.x() - opening_slope(s, k) * m.y(), m.y());
    for (int axis = 0; axis < 2; ++axis) {
      if (a.held[axis] > 0) loudest = std::max(loudest, std::abs(along[axis]));
    }
    if (k < s.island.contacts.size() && a.held.x() > 0) landing = std::max(landing, std::abs(along.x()));
  }
  if (loudest <= unheard_m_per_s) return true;
  return project(s, missing) && (landing <= trial_.fall_m() / dt || friction_has(s, missing, dt));
}

/// `missing`: of each action, weighted by what holds. False where there is no solution.
bool ConstrainedVelocities::project(IslandEquations& s, const std::vector<Eigen::Vector2d>& missing) {
  s.set_block_matrices();
  s.residual.setZero();
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    Interaction& a = s.actions[k];
    a.stiffness = a.held_stiffness(opening_slope(s, k));
    s.add_stiffness(a);
    const Point acting = std::exchange(a.force, missing[k]);
    for (const bool second : {false, true}) {
      if (!trial_.moves(a.block(second))) continue;
      const auto b = at(a.block(second));
      const Vector6 push = trial_.placement[b].generalized((second ? -1 : 1) * a.pull(), a.at(second));
      s.unknowns->add(s.local(static_cast<int>(b)), push, s.residual);
    }
    a.force = acting;
  }
  if (!s.solve(/*symmetric=*/true)) return false;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    state_.blocks[at(s.island.blocks[k])].velocity += s.unknowns->take_own(static_cast<int>(k), s.correction);
  }
  return true;
}

/// The force of the step gives a landing block between zero and twice the impulse that stops it, depending on the time
/// of contact in the step; the velocity correction provides the rest. Friction is bounded by the total.
bool ConstrainedVelocities::friction_has(const IslandEquations& s, const std::vector<Eigen::Vector2d>& missing,
                                         double dt) const {
  constexpr double least = 1e-2;  // of the normal impulse: less is how blocks ring by their strains
  const Trial now = trial_.now();
  for (std::size_t k = 0; k < s.island.contacts.size(); ++k) {
    const Interaction& a = s.actions[k];
    if (a.held.x() == 0 || opening_slope(s, k) != 0) continue;
    Eigen::Vector2d parting = Eigen::Vector2d::Zero();
    for (const bool second : {false, true}) {
      if (!trial_.moves(a.block(second))) continue;
      const auto b = at(a.block(second));
      const Vector6 change =
          trial_.rate(b, trial_.placement[b], s.unknowns->take_own(s.local(a.block(second)), s.correction));
      parting += (second ? -1 : 1) * (a.shape(trial_.placement[b], second) * change);
    }
    const Eigen::Vector2d acted = impulse_per_force(dt) * a.force;
    const Eigen::Vector2d impulse = acted + missing[k] - a.stiffness * parting;
    const int index = s.island.contacts[k];
    const ContactPoint& c = state_.contacts[at(index)];
    const ForceRule rule = formulation_->ruled_contact(now, index, c, edge_frame(now, c)).rule;
    const double bound = impulse_per_force(dt) * rule.cohesion + rule.friction * std::max(0.0, impulse.x());
    const double too_much = std::abs(impulse.y()) - bound;
    const bool slips = a.held.y() == 0;
    if ((slips ? std::abs(too_much) : too_much) > least * rule.friction * std::abs(acted.x())) return false;
  }
  return true;
}

/// As sweeps have them, of an island that was solved.
void ConstrainedVelocities::set_rows(IslandEquations& s) {
  const Trial now = trial_.now();
  SweepRows rows(step_);
  s.residual.setZero();
  if (!rows.begin(s)) return;
  for (std::size_t i = 0; i < s.actions.size(); ++i) {
    const Interaction& a = s.actions[i];
    Ruled ruled;
    if (i < s.island.contacts.size()) {
      const int k = s.island.contacts[i];
      const ContactPoint& c = state_.contacts[at(k)];
      ruled = formulation_->ruled_contact(now, k, c, edge_frame(now, c));
    } else if (i < s.island.contacts.size() + s.island.supports.size()) {
      const int k = s.island.supports[i - s.island.contacts.size()];
      ruled = formulation_->ruled_support(now, k, state_.supports[at(k)]);
    }
    rows.add(s, ruled, a, a.force);
  }
}

/// What an action's end on a moving base adds to its gap and slip in a second.
Eigen::Vector2d ConstrainedVelocities::rate_of_fixed(const Interaction& action) const {
  Eigen::Vector2d rate = Eigen::Vector2d::Zero();
  for (const bool second : {false, true}) {
    const int block = action.block(second);
    if (block < 0 || trial_.moves(block)) continue;
    rate += (second ? -1 : 1) * (action.shape(trial_.placement[at(block)], second) * state_.blocks[at(block)].velocity);
  }
  return rate;
}

/// Velocities in constrained directions become those of the constraint. A contact's total impulse in the step is
/// bounded by its friction (Moreau 1999): that of its force, and that of the correction.
void ConstrainedVelocities::settle_by_impulses(IslandEquations& s, double dt) {
  const bool falls = trial_.falls();
  const bool many_fall = s.unknowns->total > few_unknowns && falls;
  const double unheard_m_per_s = std::max(1e-9, (many_fall ? 1e-4 : 1e-6) * trial_.fall_m() / dt);
  const int most = s.unknowns->total > large_island ? 20 : falls ? 100 : 300;
  Eigen::VectorXd& beyond = s.correction;  // difference of the velocities from the required ones
  beyond.setZero();
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    const auto b = at(s.island.blocks[k]);
    const Vector6& rate = state_.blocks[b].velocity;
    const auto numbers = s.unknowns->of(static_cast<int>(k));
    for (std::size_t i = 0; i < numbers.size(); ++i) beyond[numbers[i]] = rate[static_cast<Eigen::Index>(i)];
  }
  const Eigen::VectorXd before = beyond;
  auto& rows = s.sweeps.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ForceSweeps::Row& row = rows[i];
    row.apart = rate_of_fixed(s.actions[i]);
    if (i < s.island.contacts.size()) {
      rule_of_contact(row, opening_slope(s, i), dt);
      continue;
    }
    const bool bolt = i >= s.actions.size() - s.bolts.size();
    if (!bolt) row.apart -= led_rate(s, i, dt);
    const ForceRule held{.cohesion = row.rule.cohesion,
                         .least_normal = -row.rule.most_normal,
                         .most_normal = row.rule.most_normal,
                         .opens = false};
    row.rule = bolt ? ForceRule{.most_normal = 0, .opens = false} : held;
    row.force.setZero();
  }
  s.sweeps.displace(beyond);
  step_.go_on();
  s.sweeps.settle(most, unheard_m_per_s);
  const Eigen::VectorXd change = s.sweeps.displacement() - before;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    state_.blocks[at(s.island.blocks[k])].velocity += s.unknowns->take_own(static_cast<int>(k), change);
  }
}

/// The gap and slip rates of a closed contact become zero, as far as it can press and friction has the impulse. A
/// dilating contact opens as it slips, and its friction does no work in that.
void ConstrainedVelocities::rule_of_contact(ForceSweeps::Row& row, double opening, double dt) const {
  const bool held = !row.rule.opens || !row.force.isZero(0);
  ForceRule rule{.opens = false};
  if (opening != 0 || !held) {
    rule.least_normal = -(rule.most_normal = held ? ForceRule::unbounded : 0);
    rule.opening = {opening, opening};
    rule.cohesion = held && !row.slips ? ForceRule::unbounded : 0;
    row.force.setZero();
  } else {
    rule.friction = row.rule.friction;
    rule.cohesion = impulse_per_force(dt) * row.rule.cohesion;
    rule.opens = row.rule.opens;
    if (!rule.opens) rule.least_normal = impulse_per_force(dt) * row.rule.least_normal;  // of what gives way, no more
    row.force *= impulse_per_force(dt);
  }
  row.rule = rule;
}

/// Of the step's matrix: what sweeps of velocities have in place of forces.
double ConstrainedVelocities::impulse_per_force(double dt) const {
  return trial_.scheme.mass_factor(dt) * dt;
}

double ConstrainedVelocities::opening_slope(const IslandEquations& s, std::size_t action) const {
  if (action >= s.island.contacts.size()) return 0;
  const int k = s.island.contacts[action];
  return -formulation_->progress().dilation_slope(state_.contacts[at(k)], formulation_->progress().contact(k));
}

Eigen::Vector2d ConstrainedVelocities::led_rate(const IslandEquations& s, std::size_t action, double dt) const {
  const std::size_t contacts = s.island.contacts.size();
  if (action < contacts) return Eigen::Vector2d::Zero();
  return state_.supports[at(s.island.supports[action - contacts])].target_rate(trial_.end_s, dt) +
         model_.base.velocity(trial_.end_s);
}

}  // namespace blockweir::solid
