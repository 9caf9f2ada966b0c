// SPDX-License-Identifier: GPL-3.0-or-later
// Augmented Lagrangian (7)-(8): force = multiplier - penalty * separation, multiplier <- force, until the
// penetration is below its tolerance and the forces have stopped moving.
#include <algorithm>
#include <cmath>

#include "solid/contact/formulation.hpp"

namespace blockweir::solid {
namespace {

// Penalties in units of the blocks' own stiffness at the contact: a sweep shrinks the gap to 1/(1 + ratio). Where two
// contacts work against each other, as at both ends of a pillar's base of 1:1000, it is a thousand times as large and
// more; still larger ratios cost digits in the factorization.
constexpr double largest_penalty_ratio = 1e8;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

class AugmentedLagrangian final : public Formulation {
 public:
  AugmentedLagrangian(const JointLaws& laws, const FormulationSettings& settings) : Formulation(laws, settings) {}

  /// Bounds each penalty by the stiffness with which the blocks themselves resist at the contact.
  void begin(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
             const Held& held) override {
    Formulation::begin(trial, matrix, frozen, held);
    for (const int k : held.contact_ids) bound(held.contacts[at(k)].penalty, contacts_[at(k)].stiffness);
    for (const int k : held.support_ids) bound(held.supports[at(k)].penalty, supports_[at(k)].stiffness);
  }

  Interaction contact(const Trial& trial, int index, ContactPoint& c) override {
    const EdgeFrame edge = edge_frame(trial, c);
    Progress& progress = follow(trial, index, c, edge);
    progress.round_off = separation_round_off * c.penalty * progress.separation.moved;
    const JointForce force = judge(progress, c, c.multiplier - c.penalty * progress.separation.value);
    if (force.state == ContactState::open) return {.block_i = c.vertex_part, .block_j = c.edge_part};
    Interaction action = interaction_of(trial, c, edge, progress.separation.value.y());
    action.force = progress.force;
    action.round_off = progress.round_off;
    action.stiffness(0, 0) = c.penalty;
    action.held.x() = c.penalty;
    if (force.state == ContactState::stick) {
      action.stiffness(1, 1) = action.held.y() = c.penalty;
    } else {
      const double slope = dilation_slope(c, progress);
      action.stiffness(0, 1) = slope * c.penalty;
      action.stiffness.row(1) = force.shear_per_normal * action.stiffness.row(0);
    }
    return action;
  }

  Interaction support(const Trial& trial, int index, Support& s) override {
    Progress& progress = supports_[at(index)];
    progress.separation = separation_of(trial, s);
    progress.violated = progress.separation.value;
    progress.round_off = separation_round_off * s.penalty * progress.separation.moved;
    progress.force = s.multiplier - s.penalty * progress.separation.value;
    Interaction action = interaction_of(trial, s);
    action.force = progress.force;
    action.round_off = progress.round_off;
    action.held = s.penalty * s.held();
    action.stiffness = action.held.asDiagonal().toDenseMatrix();
    return action;
  }

  /// One sweep (8): where any is not settled all multipliers are updated, for what a contact's penalty is left to carry
  /// stretches the row of blocks behind it. Penalties whose gap did not shrink fourfold are raised.
  bool sweep(const Held& held) override {
    if (all_settled(held)) return true;
    for (const int k : held.contact_ids) {
      ContactPoint& c = held.contacts[at(k)];
      if (c.state == ContactState::open) {
        c.multiplier.setZero();  // no force is left to remember
      } else {
        update(contacts_[at(k)], c.multiplier, c.penalty);
      }
    }
    for (const int k : held.support_ids) {
      update(supports_[at(k)], held.supports[at(k)].multiplier, held.supports[at(k)].penalty);
    }
    return false;
  }

 private:
  void bound(double& penalty, double stiffness) const {
    const double initial = settings_.initial_penalty.value_or(settings_.penalty_ratio * stiffness);
    penalty = std::min(penalty > 0 ? penalty : initial, settings_.penalty_ratio * stiffness);
  }

  [[nodiscard]] bool all_settled(const Held& held) const {
    const auto contact_settled = [&](int k) {
      const ContactPoint& c = held.contacts[at(k)];
      // Only an open contact that a negative multiplier held open may still have to close.
      if (c.state == ContactState::open) return c.multiplier.x() >= 0 || contacts_[at(k)].separation.value.x() >= 0;
      return settled(contacts_[at(k)], c.multiplier);
    };
    const auto support_settled = [&](int k) { return settled(supports_[at(k)], held.supports[at(k)].multiplier); };
    return std::all_of(held.contact_ids.begin(), held.contact_ids.end(), contact_settled) &&
           std::all_of(held.support_ids.begin(), held.support_ids.end(), support_settled);
  }

  [[nodiscard]] bool settled(const Progress& p, const Eigen::Vector2d& multiplier) const {
    const double violation = p.violated.cwiseAbs().maxCoeff();
    if (p.turning || violation > settings_.penetration_tolerance_m) return false;
    return violation <= settings_.position_round_off_m ||
           (p.force - multiplier).cwiseAbs().maxCoeff() <= settings_.force_tolerance_n + p.round_off;
  }

  /// Gaps of round-off size would add up in the multipliers of redundant contacts: they are left out.
  void update(Progress& progress, Eigen::Vector2d& multiplier, double& penalty) const {
    const double violation = progress.violated.cwiseAbs().maxCoeff();
    if (!progress.turning && violation <= settings_.position_round_off_m) return;
    raise_if_slow(progress, penalty);
    multiplier = progress.force;
  }

  static void raise_if_slow(Progress& progress, double& penalty) {
    const double violation = progress.violated.cwiseAbs().maxCoeff();
    if (4 * violation > progress.last_violation) {
      penalty = std::min(10 * penalty, largest_penalty_ratio * progress.stiffness);
    }
    progress.last_violation = violation;
  }
};

}  // namespace

std::unique_ptr<Formulation> make_augmented_lagrangian(const JointLaws& laws, const FormulationSettings& settings) {
  return std::make_unique<AugmentedLagrangian>(laws, settings);
}

}  // namespace blockweir::solid
