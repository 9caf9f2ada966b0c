// SPDX-License-Identifier: GPL-3.0-or-later
// Classical Lagrange multipliers: contact forces are unknowns beside the displacements, gaps and slips their equations.
// States follow the primal-dual active set: a contact is closed, sticks or slips by what multiplier less c * separation
// would be admissible to, for any c > 0.
#include <array>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/contact/formulation.hpp"

namespace blockweir::solid {
namespace {

// Contacts between two stiff faces are often redundant, the saddle-point matrix then singular: constraints give way by
// this much of the blocks' own compliance, and Newton's iterations take its trace out of the answer.
constexpr double regularization = 1e-9;

class LagrangeMultiplier final : public Formulation, private ForceConstraints {
 public:
  LagrangeMultiplier(const JointLaws& laws, const FormulationSettings& settings) : Formulation(laws, settings) {}

  void begin(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
             const IslandContacts& island) override {
    of_contacts_.resize(island.contacts.size());
    of_supports_.resize(island.supports.size());
    Formulation::begin(trial, matrix, frozen, island);
  }

  [[nodiscard]] const ForceConstraints* force_constraints() const override { return this; }

  Interaction contact(const Trial& trial, int index, ContactPoint& c) override {
    const EdgeFrame edge = edge_frame(trial, c);
    Progress& progress = progress_.follow(trial, index, c, edge);
    const JointForce stuck = judge(index, c, c.multiplier - c.penalty * progress.separation);
    Constraints& constraints = of_contacts_[at(index)];
    constraints.count = 0;
    if (stuck.state == ContactState::open) return {.block_i = c.vertex_part, .block_j = c.edge_part};
    Interaction action = interaction_of(c, edge, progress.separation.y());
    const double compliance = regularization / c.penalty;
    double shear = c.multiplier.y();
    double slope = 0;
    if (stuck.state == ContactState::slip) {
      const double bound = laws_.strength(c, c.multiplier.x()).shear_bound(c.multiplier.x());
      shear = std::copysign(bound, stuck.shear);
      slope = progress_.dilation_slope(c, progress);
    } else {
      constraints.all[1] = {{0, 1}, {0, 1}, violation(progress.separation.y()), compliance};
    }
    constraints.all[0] = {{1, slope}, {1, stuck.shear_per_normal}, violation(progress.separation.x()), compliance};
    constraints.count = stuck.state == ContactState::stick ? 2 : 1;
    action.force = c.force = {c.multiplier.x(), shear};
    action.held = {c.penalty, stuck.state == ContactState::stick ? c.penalty : 0};
    action.stiffness.row(0) << c.penalty, slope * c.penalty;  // which way it holds
    return action;
  }

  Interaction support(const Trial& trial, int index, Support& s) override {
    const Progress& progress = progress_.follow(trial, index, s);
    Interaction action = interaction_of(s);
    action.force = s.force = s.multiplier;
    action.held = s.penalty * s.held();
    Constraints& constraints = of_supports_[at(index)];
    constraints.count = 0;
    for (int axis = 0; axis < 2; ++axis) {
      if (s.held()[axis] == 0) continue;
      const Eigen::Vector2d unit = Eigen::Vector2d::Unit(axis);
      constraints.all[constraints.count++] = {unit, unit, violation(progress.separation[axis]),
                                              regularization / s.penalty};
    }
    return action;
  }

  bool sweep(const IslandContacts& island) override {
    bool settled = true;
    const auto within = [this](const Progress& p, const auto& constraint) {
      return !p.turning && p.violation(constraint.state) <= settings_.penetration_tolerance_m;
    };
    for (const int k : island.contact_ids) {
      ContactPoint& c = island.contacts[at(k)];
      if (c.state == ContactState::open) c.multiplier.setZero();
      settled = settled && within(progress_.contact(k), c);
    }
    for (const int k : island.support_ids) settled = settled && within(progress_.support(k), island.supports[at(k)]);
    return settled;
  }

 private:
  struct Constraints {
    std::size_t count = 0;
    std::array<Constraint, 2> all;
    [[nodiscard]] std::span<const Constraint> span() const { return {all.data(), count}; }
  };

  [[nodiscard]] std::span<const Constraint> of_contact(int index) const override {
    return of_contacts_[at(index)].span();
  }
  [[nodiscard]] std::span<const Constraint> of_support(int index) const override {
    return of_supports_[at(index)].span();
  }
  /// Axes without a constraint get what the law says at the corrected normal force.
  void correct(ContactPoint& c, const Eigen::Vector2d& force) const override {
    if (c.state == ContactState::open) return c.multiplier.setZero(), void();
    c.multiplier = c.force + force;
  }
  void correct(Support& s, const Eigen::Vector2d& force) const override { s.multiplier += force; }

  void begin_contact(const Trial& /*trial*/, const std::vector<bool>& /*frozen*/, int k, ContactPoint& c) override {
    c.penalty = progress_.contact(k).stiffness;
  }
  void begin_support(const Trial& /*trial*/, int k, Support& s) override { s.penalty = progress_.support(k).stiffness; }

  /// A tenth of what the tolerance lets be is none: redundant constraints would make forces of it, over their
  /// compliance. Ten times as much would show in the accelerations of short steps.
  [[nodiscard]] double violation(double separation_m) const {
    return std::abs(separation_m) <= 0.1 * settings_.penetration_tolerance_m ? 0 : separation_m;
  }

  std::vector<Constraints> of_contacts_;
  std::vector<Constraints> of_supports_;
};

}  // namespace

std::unique_ptr<Formulation> make_lagrange_multiplier(const JointLaws& laws, const FormulationSettings& settings) {
  return std::make_unique<LagrangeMultiplier>(laws, settings);
}

}  // namespace blockweir::solid
