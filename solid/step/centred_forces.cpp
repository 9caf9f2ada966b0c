// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/centred_forces.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/step/moves_little.hpp"

namespace blockweir::solid {
namespace {

constexpr int most_solutions = 30;
constexpr double most_lost = 0.99;    // of a distance in one correction
constexpr double least_force = 1e-3;  // of the largest load: where a force of the step before is at its bound
constexpr double far_force = 30;      // where there are none from a step before
constexpr double round_off = 1e-8;    // of all loads: solutions near the limit leave as much
constexpr double inertia = 1e-14;     // in units of the stiffnesses: regular where forces leave a motion open

/// Bonds that break do so when blocks have strained, not when no forces are left that hold them.
bool lasts(const JointProperties& law) {
  return law.keeps_cohesion && law.is_straight();
}

}  // namespace

bool CentredForces::suits(const IslandEquations& s, const StepMode& mode) const {
  if (model_.base.moves_supports()) return false;  // what rests on the ground goes with it
  const bool many = s.unknowns->total > few_unknowns && s.unknowns->total == 3 * s.unknowns->blocks();
  return many && !mode.settles && !mode.friction_lags && !step_.substitute &&
         formulation_->force_constraints() == nullptr && formulation_->holds_exactly() && !s.moves_as_one() &&
         s.island.supports.empty() && s.bolts.empty();
}

bool CentredForces::may_hold(const IslandEquations& s, const StepMode& mode) const {
  return suits(s, mode) && moves_little(step_, s);
}

Held CentredForces::hold(IslandEquations& s) {
  if (!begin(s)) return Held::unknown;
  const double tolerance_n = formulation_->settings().force_tolerance_n;
  const double round_off_n = round_off * loads_.cwiseAbs().sum();
  for (int solutions = 0;; ++solutions) {
    const double left = unbalanced(s);
    if (left <= tolerance_n || (whole_ && solutions > 0 && left <= round_off_n)) break;
    if (solutions == most_solutions || !find_changes(s)) return Held::unknown;
    if (none_can_hold(s)) return Held::no;
    change();
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
  const auto acts = [this](int k) { return !state_.contacts[at(k)].force.isZero(0); };
  whole_ = std::any_of(s.island.contacts.begin(), s.island.contacts.end(), acts);
  const double least = (whole_ ? least_force : far_force) * loads_.cwiseAbs().maxCoeff();
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
  }
  return true;
}

/// By the forces, which the actions take.
double CentredForces::unbalanced(IslandEquations& s) {
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (!forces_[i].open()) s.actions[i].force = forces_[i].force();
  }
  s.balance_alone();
  return s.find_residual([&](std::size_t k) { s.add_forces(k); });
}

/// Mehrotra's predictor and corrector (1992), but from forces that were next to balance a step towards the centre.
bool CentredForces::find_changes(IslandEquations& s) {
  set_stiffnesses(s);
  if (whole_) {
    find_residual_at_rest(s, 1);
    if (!s.solve_symmetric()) return false;
    set_changes(s, 1);
    return true;
  }
  s.system().forget_factors();
  if (!s.solve_symmetric()) return false;
  set_changes(s, 0);
  const auto [of_forces, of_motions] = fractions(1);
  const double now = mean_product(0, 0);
  const double share = mean_product(of_forces, of_motions) / now;
  for (BoundedForce& f : forces_) {
    for (ComplementaryPair& p : f.distances()) p.product_change = p.force_change * p.motion_change;
  }
  const double aim = share * share * share * now;
  find_residual_at_rest(s, aim);
  s.correction = s.system().solve_again(s.residual);
  set_changes(s, aim);
  return s.correction.allFinite();
}

/// The inverse of the Hessian of a sum of logarithms is that of springs.
void CentredForces::set_stiffnesses(IslandEquations& s) {
  double largest = 0;
  for (const int block : s.island.blocks) largest = std::max(largest, trial_.matrix[at(block)](0, 0));
  double squares = 0;
  double number = 0;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    s.actions[i].stiffness.setZero();
    if (forces_[i].open()) continue;
    s.actions[i].stiffness = forces_[i].stiffness();
    squares += s.actions[i].stiffness(0, 0);
    number += 2;
  }
  share_ = largest * number / (inertia * squares);
  for (Interaction& action : s.actions) action.stiffness *= share_;
}

/// Newton's method on A^T y = z and L + A f = 0, f the forces, L the loads, A what the forces do to the blocks, y a
/// motion of these, z its part against each distance d, the products d z a given one: with K the stiffness of all
/// contacts, (A K A^T) y = L + A (f + df0), then df = df0 - K A^T y, df0 the change at rest. L + A (f + df0) is this.
void CentredForces::find_residual_at_rest(IslandEquations& s, double product) {
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (!forces_[i].open()) s.actions[i].force = forces_[i].force() + forces_[i].change_at_rest(product);
  }
  s.balance_alone();
  s.find_residual([&](std::size_t k) { s.add_forces(k); });
}

void CentredForces::set_changes(const IslandEquations& s, double product) {
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
    forces_[i].set_changes(product, share_ * motion);
  }
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

/// Of the changes of forces and of motions, at most one, that use so much of a distance or a motion.
CentredForces::Fractions CentredForces::fractions(double within) const {
  Fractions all;
  for (const BoundedForce& f : forces_) {
    for (const ComplementaryPair& p : f.distances()) {
      all.of_forces = std::min(all.of_forces, p.force_fraction(within));
      all.of_motions = std::min(all.of_motions, p.motion_fraction(within));
    }
  }
  return all;
}

double CentredForces::mean_product(double of_forces, double of_motions) const {
  double sum = 0;
  double number = 0;
  for (const BoundedForce& f : forces_) {
    for (const ComplementaryPair& p : f.distances()) sum += p.product_after(of_forces, of_motions);
    number += static_cast<double>(f.distances().size());
  }
  return sum / number;
}

/// By no more than what leaves every distance a part of itself.
void CentredForces::change() {
  const auto [of_forces, of_motions] = fractions(most_lost);
  for (BoundedForce& f : forces_) {
    for (ComplementaryPair& p : f.distances()) {
      p.force += of_forces * p.force_change;
      p.motion += of_motions * p.motion_change;
      p.product_change = 0;
    }
  }
  whole_ = of_forces == 1;
}

void CentredForces::take(IslandEquations& s) {
  const Trial now = trial_.now();
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const int k = s.island.contacts[i];
    formulation_->take_contact(now, k, state_.contacts[at(k)], {.force = forces_[i].force(), .exact = true});
  }
}

}  // namespace blockweir::solid
