// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/centred_forces.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/step/moves_little.hpp"

namespace blockweir::solid {
namespace {

constexpr int most_solutions = 30;
constexpr double most_lost = 0.9;     // of a distance in one correction
constexpr double least_force = 1e-3;  // of the largest load: where a force of the step before is at its bound
constexpr double round_off = 1e-9;    // of all loads: solutions near the limit leave as much
constexpr double inertia = 1e-14;     // in units of the stiffnesses: regular where forces leave a motion open

/// Bonds that break do so when blocks have strained, not when no forces are left that hold them.
bool lasts(const JointProperties& law) {
  return law.keeps_cohesion && law.is_straight();
}

}  // namespace

bool CentredForces::may_hold(const IslandEquations& s, const StepMode& mode) const {
  if (model_.base.moves_supports()) return false;  // what rests on the ground goes with it
  const bool many = s.unknowns->total > few_unknowns && s.unknowns->total == 3 * s.unknowns->blocks();
  return many && !mode.settles && !mode.friction_lags && !step_.substitute &&
         formulation_->force_constraints() == nullptr && formulation_->holds_exactly() && !s.moves_as_one() &&
         s.island.supports.empty() && s.bolts.empty() && moves_little(step_, s);
}

Held CentredForces::hold(IslandEquations& s) {
  if (!begin(s)) return Held::unknown;
  const double tolerance_n = formulation_->settings().force_tolerance_n;
  const double round_off_n = round_off * loads_.cwiseAbs().sum();
  double taken = 0;  // of the last changes; whole ones leave nothing but round-off
  for (int solutions = 0;; ++solutions) {
    s.balance_alone();
    const double left = s.find_residual([&](std::size_t k) { s.add_forces(k); });
    if (left <= tolerance_n || (taken == 1 && left <= round_off_n)) break;
    if (solutions == most_solutions || !find_changes(s)) return Held::unknown;
    if (none_can_hold(s)) return Held::no;
    taken = change(s);
  }
  take(s);
  return Held::yes;
}

/// Nothing moves; forces of the step before, away from their bounds. False where a contact has another law.
bool CentredForces::begin(IslandEquations& s) {
  for (const int block : s.island.blocks) trial_.go_to(at(block), Vector6::Zero());
  s.balance_alone();
  s.find_residual({});
  loads_ = s.residual;
  const double least = least_force * loads_.cwiseAbs().maxCoeff();
  const Trial now = trial_.now();
  forces_.assign(s.island.contacts.size(), {});
  s.actions.resize(forces_.size());
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const int k = s.island.contacts[i];
    const ContactPoint& c = state_.contacts[at(k)];
    const EdgeFrame edge = edge_frame(now, c);
    Ruled ruled = formulation_->ruled_contact(now, k, c, edge);
    if (!ruled.rule.is_dry()) {
      if (!lasts(model_.laws[c.law]) || !BoundedForce::fits(ruled.rule)) return false;
      ruled.rule.least_normal = -model_.laws.strength(c, 0).tension;
    }
    s.actions[i] = interaction_of(c, edge, ruled.apart.y());
    if (ruled.apart.x() > formulation_->settings().penetration_tolerance_m) continue;
    forces_[i] = BoundedForce(ruled.rule, c.force, least);
    s.actions[i].force = forces_[i].force();
  }
  return true;
}

/// The Hessian of the sum of logarithms, inverted, is that of springs.
void CentredForces::set_stiffnesses(IslandEquations& s) {
  double largest = 0;
  for (const int block : s.island.blocks) largest = std::max(largest, trial_.matrix[at(block)](0, 0));
  double squares = 0;
  double number = 0;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    s.actions[i].stiffness.setZero();
    if (forces_[i].open()) continue;
    s.actions[i].stiffness = forces_[i].squares();
    squares += s.actions[i].stiffness(0, 0);
    number += 2;
  }
  share_ = largest * number / (inertia * squares);
  for (Interaction& action : s.actions) action.stiffness *= share_;
}

/// Newton's method on g(f) = A^T y and L + A f = 0, f the forces, g the gradient of the logarithms, L the loads, A what
/// the forces do to the blocks, y multipliers: with K the inverse of g's derivative, negative,
/// (A K A^T) y = L + A (f + K g), then f + df = f + K (g - A^T y).
bool CentredForces::find_changes(IslandEquations& s) {
  set_stiffnesses(s);
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (!forces_[i].open()) s.actions[i].force += forces_[i].to_centre();
  }
  s.balance_alone();
  s.find_residual([&](std::size_t k) { s.add_forces(k); });
  if (!s.solve_symmetric()) return false;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (forces_[i].open()) continue;
    Eigen::Vector2d motion = Eigen::Vector2d::Zero();
    for (const bool second : {false, true}) {
      const int block = s.actions[i].block(second);
      if (!trial_.moves(block)) continue;
      const auto first = s.unknowns->first[at(s.local(block))];
      motion += (second ? -1 : 1) * s.actions[i].rigid_shape(trial_.placement[at(block)], second) *
                s.correction.segment<3>(first);
    }
    forces_[i].set_motion(share_ * motion);
  }
  return true;
}

/// Farkas' lemma: no admissible forces balance the loads if these do more work along a motion y that opens all
/// contacts, slip opening them by the tangent of friction, than bonds resist. Where some would close, it takes forces
/// that are large against all loads.
bool CentredForces::none_can_hold(const IslandEquations& s) const {
  constexpr double large = 100;
  double closes = 0;
  double resists = 0;
  for (const BoundedForce& f : forces_) {
    if (f.open()) continue;
    closes += f.closes();
    resists += f.resists();
  }
  return share_ * loads_.dot(s.correction) > large * loads_.cwiseAbs().sum() * closes + resists;
}

/// By no more than what leaves every distance a part of itself; returns the part that was taken.
double CentredForces::change(IslandEquations& s) {
  double lost = most_lost;
  for (const BoundedForce& f : forces_) {
    if (!f.open()) lost = std::max(lost, f.lost());
  }
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (forces_[i].open()) continue;
    forces_[i].change(most_lost / lost);
    s.actions[i].force = forces_[i].force();
  }
  return most_lost / lost;
}

void CentredForces::take(IslandEquations& s) {
  const Trial now = trial_.now();
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const int k = s.island.contacts[i];
    formulation_->take_contact(now, k, state_.contacts[at(k)], {.force = forces_[i].force(), .exact = true});
  }
}

}  // namespace blockweir::solid
