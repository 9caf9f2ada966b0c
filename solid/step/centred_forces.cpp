// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/centred_forces.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/step/moves_little.hpp"

namespace blockweir::solid {
namespace {

constexpr int most_solutions = 30;
constexpr double most_lost = 0.9;     // of a force in one correction
constexpr double least_force = 1e-3;  // of the largest load: where a force of the step before is at its bound
constexpr double inertia = 1e-14;     // in units of the stiffnesses: regular where forces leave a motion open

}  // namespace

bool CentredForces::may_hold(const IslandEquations& s, const StepMode& mode) const {
  const bool many = s.unknowns->total > few_unknowns && s.unknowns->total == 3 * s.unknowns->blocks();
  return many && mode.in_motion() && !mode.settles && !mode.friction_lags && !step_.substitute &&
         formulation_->force_constraints() == nullptr && formulation_->holds_exactly() && !s.moves_as_one() &&
         s.island.supports.empty() && s.bolts.empty() && moves_little(step_, s);
}

bool CentredForces::hold(IslandEquations& s) {
  if (!begin(s)) return false;
  for (int solutions = 0;; ++solutions) {
    s.balance_alone();
    const double left = s.find_residual([&](std::size_t k) { s.add_forces(k); });
    if (left <= formulation_->settings().force_tolerance_n) break;
    if (solutions == most_solutions || !find_changes(s) || none_can_hold(s)) return false;
    change(s);
  }
  take(s);
  return true;
}

/// Nothing moves; forces of the step before, away from their bounds. False where a contact has another law.
bool CentredForces::begin(IslandEquations& s) {
  for (const int block : s.island.blocks) trial_.go_to(at(block), Vector6::Zero());
  s.balance_alone();
  s.find_residual({});
  loads_ = s.residual;
  const double least = least_force * loads_.cwiseAbs().maxCoeff();
  const Trial now = trial_.now();
  cones_.resize(s.island.contacts.size());
  s.actions.resize(cones_.size());
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const int k = s.island.contacts[i];
    const ContactPoint& c = state_.contacts[at(k)];
    const Ruled ruled = formulation_->ruled_contact(now, k, c);
    if (!ruled.rule.is_dry()) return false;
    s.actions[i] = interaction_of(c, edge_frame(now, c), ruled.apart.y());
    cones_[i] = {.friction = ruled.rule.friction};
    if (ruled.apart.x() > formulation_->settings().penetration_tolerance_m) continue;
    const double half = c.force.x() / 2;
    const double skewed = ruled.rule.friction > 0 ? c.force.y() / (2 * ruled.rule.friction) : 0;
    cones_[i].minus = std::max(half - skewed, least);
    cones_[i].plus = std::max(half + skewed, least);
    s.actions[i].force = cones_[i].force();
  }
  return true;
}

/// The Hessian of the sum of logarithms is that of springs whose stiffnesses are the forces' squares.
void CentredForces::set_stiffnesses(IslandEquations& s) {
  double largest = 0;
  for (const int block : s.island.blocks) largest = std::max(largest, trial_.matrix[at(block)](0, 0));
  double squares = 0;
  double number = 0;
  for (const Cone& c : cones_) {
    squares += c.minus * c.minus + c.plus * c.plus;
    number += c.open() ? 0 : 2;
  }
  share_ = largest * number / (inertia * squares);
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const auto& [f, minus, plus, minus_change, plus_change] = cones_[i];
    const double a = share_ * minus * minus;
    const double b = share_ * plus * plus;
    s.actions[i].stiffness << a + b, f * (b - a), f * (b - a), f * f * (a + b);
  }
}

/// Newton's method on 1/p = A^T y and L + A p = 0, p the forces along edges of cones, L the loads, A what the forces do
/// to the blocks, y multipliers: (A P^2 A^T) y = L + 2 A p, then p + dp = 2 p - P^2 A^T y.
bool CentredForces::find_changes(IslandEquations& s) {
  set_stiffnesses(s);
  s.residual = 2 * s.residual - loads_;
  if (!s.solve_symmetric()) return false;
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    Cone& c = cones_[i];
    if (c.open()) continue;
    Eigen::Vector2d motion = Eigen::Vector2d::Zero();
    for (const bool second : {false, true}) {
      const int block = s.actions[i].block(second);
      if (!trial_.moves(block)) continue;
      const auto first = s.unknowns->first[at(s.local(block))];
      motion += (second ? -1 : 1) * s.actions[i].rigid_shape(trial_.placement[at(block)], second) *
                s.correction.segment<3>(first);
    }
    c.minus_change = c.minus - share_ * c.minus * c.minus * (motion.x() - c.friction * motion.y());
    c.plus_change = c.plus - share_ * c.plus * c.plus * (motion.x() + c.friction * motion.y());
  }
  return true;
}

/// Farkas' lemma: no admissible forces balance the loads if these do work along a motion y that opens all contacts,
/// slip opening them by the tangent of friction. Where some would close, it takes forces that are large against all
/// loads.
bool CentredForces::none_can_hold(const IslandEquations& s) const {
  constexpr double large = 100;
  double closes = 0;
  for (const Cone& c : cones_) {
    if (c.open()) continue;
    closes +=
        std::max(0.0, c.minus_change / c.minus - 1) / c.minus + std::max(0.0, c.plus_change / c.plus - 1) / c.plus;
  }
  return share_ * loads_.dot(s.correction) > large * loads_.cwiseAbs().sum() * closes;
}

void CentredForces::change(IslandEquations& s) {
  const double fraction = positive_fraction();
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    Cone& c = cones_[i];
    c.minus += fraction * c.minus_change;
    c.plus += fraction * c.plus_change;
    s.actions[i].force = c.force();
  }
}

/// The part of the changes, at most one, by which no force loses more than it may.
double CentredForces::positive_fraction() const {
  double lost = most_lost;
  for (const Cone& c : cones_) {
    if (!c.open()) lost = std::max({lost, -c.minus_change / c.minus, -c.plus_change / c.plus});
  }
  return most_lost / lost;
}

void CentredForces::take(IslandEquations& s) {
  const Trial now = trial_.now();
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const int k = s.island.contacts[i];
    formulation_->take_contact(now, k, state_.contacts[at(k)], {.force = cones_[i].force(), .exact = true});
  }
}

}  // namespace blockweir::solid
