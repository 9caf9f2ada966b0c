// SPDX-License-Identifier: GPL-3.0-or-later
// Augmented Lagrangian (7)-(8): force = multiplier - penalty * separation, multiplier <- force, until the
// penetration is below its tolerance and the forces have stopped moving.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/contact/formulation.hpp"

namespace blockweir::solid {
namespace {

// Penalties in units of the blocks' own stiffness at the contact: a sweep shrinks the gap to 1/(1 + ratio). Where two
// contacts work against each other, as at both ends of a pillar's base of 1:1000, it is a thousand times as large and
// more; still larger ratios cost digits in the factorization.
constexpr double largest_penalty_ratio = 1e8;

class AugmentedLagrangian final : public Formulation {
 public:
  AugmentedLagrangian(const JointLaws& laws, const FormulationSettings& settings) : Formulation(laws, settings) {}

  Interaction contact(const Trial& trial, int index, ContactPoint& c) override {
    const EdgeFrame edge = edge_frame(trial, c);
    Progress& progress = progress_.follow(trial, index, c, edge);
    const JointForce force = judge(index, c, c.multiplier - c.penalty * progress.separation);
    if (settings_.friction_lags) return with_lagging_friction(c, edge, progress, lagged_.bounds[index]);
    if (force.state == ContactState::open) return {.block_i = c.vertex_part, .block_j = c.edge_part};
    Interaction action = interaction_of(c, edge, progress.separation.y());
    action.force = c.force;
    action.round_off = progress.round_off;
    action.stiffness(0, 0) = c.penalty;
    action.held.x() = c.penalty;
    if (force.state == ContactState::stick) {
      action.stiffness(1, 1) = action.held.y() = c.penalty;
    } else {
      const double slope = progress_.dilation_slope(c, progress);
      action.stiffness(0, 1) = slope * c.penalty;
      action.stiffness.row(1) = force.shear_per_normal * action.stiffness.row(0);
    }
    return action;
  }

  Interaction support(const Trial& trial, int index, Support& s) override {
    const Progress& progress = progress_.follow(trial, index, s);
    s.force = s.multiplier - s.penalty * progress.separation;
    Interaction action = interaction_of(s);
    action.force = s.force;
    action.round_off = progress.round_off;
    action.held = s.penalty * s.held();
    action.stiffness = action.held.asDiagonal().toDenseMatrix();
    return action;
  }

  /// One sweep (8): where any is not settled all multipliers are updated, for what a contact's penalty is left to carry
  /// stretches the row of blocks behind it. Penalties that are low, or whose gap did not shrink fourfold, are raised.
  bool sweep(const IslandContacts& island) override {
    if (all_settled(island)) return true;
    if (settings_.friction_lags) raise_together(island);
    for_each(island.contact_ids.size(), [&](std::size_t i) {
      const int k = island.contact_ids[i];
      ContactPoint& c = island.contacts[at(k)];
      if (c.state == ContactState::open) {
        c.multiplier.setZero();  // no force is left to remember
      } else {
        update(progress_.contact(k), c);
      }
    });
    for (const int k : island.support_ids) update(progress_.support(k), island.supports[at(k)]);
    return false;
  }

  [[nodiscard]] double unsettled(const IslandContacts& island) const override {
    const auto moves_by = [&](const Progress& p, const auto& constraint) {
      if (closed(p.violation(constraint.state))) return 0.0;
      return (constraint.force - constraint.multiplier).cwiseAbs().maxCoeff();
    };
    double most = largest(island.contact_ids.size(), [&](std::size_t i) {
      const int k = island.contact_ids[i];
      return moves_by(progress_.contact(k), island.contacts[at(k)]);
    });
    for (const int k : island.support_ids) {
      most = std::max(most, moves_by(progress_.support(k), island.supports[at(k)]));
    }
    return most;
  }

  /// What a sweep has left in multipliers for gaps of round-off size to take, bounds that have moved since, and
  /// penalties that were higher then would make other forces of the same gaps.
  void keep_forces(const Trial& trial, const IslandContacts& island) override {
    for_each(island.contact_ids.size(), [&](std::size_t i) {
      const int k = island.contact_ids[i];
      ContactPoint& c = island.contacts[at(k)];
      Progress& progress = progress_.follow(trial, k, c, edge_frame(trial, c));
      progress.slip_force = c.force.y();
      c.multiplier = c.force;
      if (c.state != ContactState::open) c.multiplier.x() += c.penalty * progress.separation.x();
      if (c.state == ContactState::stick) c.multiplier.y() += c.penalty * progress.separation.y();
    });
  }

  [[nodiscard]] LaggedFriction* lagged_friction() override { return &lagged_; }

 private:
  /// Bounds the penalty by the stiffness with which the blocks themselves resist at the contact. Its change is no
  /// reason for the force to change.
  void begin_contact(const Trial& trial, const std::vector<bool>& /*frozen*/, int k, ContactPoint& c) override {
    const double change = bound(c.penalty, progress_.contact(k).stiffness);
    if (change == 0 || c.state == ContactState::open) return;
    c.multiplier += change * progress_.follow(trial, k, c, edge_frame(trial, c)).separation;
  }
  void begin_support(const Trial& trial, int k, Support& s) override {
    const double change = bound(s.penalty, progress_.support(k).stiffness);
    if (change != 0) s.multiplier += change * (separation_of(trial, s).value + s.led);  // as the last step left it
  }

  /// Shear bounded by what does not depend on the normal force: a symmetric tangent.
  [[nodiscard]] static Interaction with_lagging_friction(const ContactPoint& c, const EdgeFrame& edge,
                                                         const Progress& progress, double bound) {
    const bool closed = c.state != ContactState::open;
    if (!closed && bound == 0) return {.block_i = c.vertex_part, .block_j = c.edge_part};
    Interaction action = interaction_of(c, edge, progress.separation.y());
    action.force = c.force;
    action.round_off = progress.round_off;
    action.stiffness(0, 0) = closed ? c.penalty : 0;
    action.stiffness(1, 1) = std::abs(c.force.y()) < bound ? c.penalty : 0;
    action.held = {action.stiffness(0, 0), c.state == ContactState::stick ? c.penalty : 0};
    return action;
  }

  /// Returns by how much it changes a penalty that has been in use.
  [[nodiscard]] double bound(double& penalty, double stiffness) const {
    const double initial = settings_.initial_penalty.value_or(settings_.penalty_ratio * stiffness);
    const double before = penalty;
    penalty = std::min(before > 0 ? before : initial, settings_.penalty_ratio * stiffness);
    return before > 0 ? penalty - before : 0;
  }

  [[nodiscard]] bool all_settled(const IslandContacts& island) const {
    const auto contact_settled = [&](std::size_t i) {
      const int k = island.contact_ids[i];
      const ContactPoint& c = island.contacts[at(k)];
      // Only an open contact that a negative multiplier held open may still have to close.
      if (c.state == ContactState::open) return c.multiplier.x() >= 0 || progress_.contact(k).separation.x() >= 0;
      return settled(progress_.contact(k), c);
    };
    const auto support_settled = [&](int k) { return settled(progress_.support(k), island.supports[at(k)]); };
    return all_of(island.contact_ids.size(), contact_settled) &&
           std::all_of(island.support_ids.begin(), island.support_ids.end(), support_settled);
  }

  /// As far as coordinates know.
  [[nodiscard]] bool closed(double violation) const {
    return violation <= settings_.closed_round_offs * settings_.position_round_off_m;
  }

  template <class ContactOrSupport>
  [[nodiscard]] bool settled(const Progress& p, const ContactOrSupport& constraint) const {
    const double violation = p.violation(constraint.state);
    if (p.turning) return false;
    if (closed(violation)) return true;
    return violation <= settings_.penetration_tolerance_m &&
           (constraint.force - constraint.multiplier).cwiseAbs().maxCoeff() <=
               settings_.force_tolerance_n + p.round_off;
  }

  /// Gaps of round-off size would add up in the multipliers of redundant contacts: they are left out.
  template <class ContactOrSupport>
  void update(Progress& progress, ContactOrSupport& constraint) const {
    const double violation = progress.violation(constraint.state);
    if (!progress.turning && violation <= settings_.position_round_off_m) return;
    // The large penalties of held joints leave redundant contacts what a few round-offs make of their gaps: larger ones
    // would only make more force of that.
    const bool shrinks = !settings_.joints_held || violation > 4 * settings_.position_round_off_m;
    if (!settings_.friction_lags && shrinks) raise_if_slow(progress, constraint.penalty, violation);
    constraint.multiplier = constraint.force;
  }

  /// While friction lags, all by as much and less at a time: a contact whose penalty stands out has a range of slips so
  /// narrow that Newton's method passes it by, and forces that redundant contacts leave open would follow their bounds
  /// in leaps.
  void raise_together(const IslandContacts& island) {
    constexpr double slow = 1.5;
    constexpr double rise = 3;
    double worst = 0;
    double worst_before = 0;
    const auto look = [&](Progress& p, const auto& constraint) {
      const double violation = p.violation(constraint.state);
      worst = std::max(worst, violation);
      worst_before = std::max(worst_before, std::exchange(p.last_violation, violation));
    };
    for (const int k : island.contact_ids) look(progress_.contact(k), island.contacts[at(k)]);
    for (const int k : island.support_ids) look(progress_.support(k), island.supports[at(k)]);
    if (slow * worst <= worst_before) return;
    const auto raise = [&](const Progress& p, double& penalty) {
      penalty = std::min(rise * penalty, largest_penalty_ratio * p.stiffness);
    };
    for (const int k : island.contact_ids) raise(progress_.contact(k), island.contacts[at(k)].penalty);
    for (const int k : island.support_ids) raise(progress_.support(k), island.supports[at(k)].penalty);
  }

  /// Where the scene starts it lower than steps choose by themselves it rises with each sweep: up to there it costs no
  /// digits.
  void raise_if_slow(Progress& progress, double& penalty, double violation) const {
    const bool low = settings_.initial_penalty && 10 * penalty <= settings_.penalty_ratio * progress.stiffness;
    if (low || 4 * violation > progress.last_violation) {
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
