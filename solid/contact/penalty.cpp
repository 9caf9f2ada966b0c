// SPDX-License-Identifier: GPL-3.0-or-later
// Penalty method: a contact is a spring, and a dashpot where the scene says so. The penetration is what the spring
// needs.
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/contact/formulation.hpp"

namespace blockweir::solid {
namespace {

constexpr double stiffness_over_modulus = 40;  // springs that give a tenth of a per cent of a block's own strain

class Penalty final : public Formulation {
 public:
  Penalty(const JointLaws& laws, const FormulationSettings& settings)
      : Formulation(laws, settings),
        spring_(settings.contact_stiffness.value_or(stiffness_over_modulus * settings.largest_modulus_pa)) {}

  void begin(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
             const IslandContacts& island) override {
    dashpots_.resize(island.contacts.size());
    Formulation::begin(trial, matrix, frozen, island);
  }

  Interaction contact(const Trial& trial, int index, ContactPoint& c) override {
    const EdgeFrame edge = edge_frame(trial, c);
    Progress& progress = progress_.follow(trial, index, c, edge);
    const Dashpot& dashpot = dashpots_[at(index)];
    const Eigen::Vector2d& apart = progress.separation;
    const Eigen::Vector2d moved = apart - dashpot.start;  // since the start of the step
    const Eigen::Vector2d rate = trial.velocity_factor * moved + dashpot.past_rate;
    const JointForce force = judge(index, c, -spring_ * apart - dashpot.coefficient * rate);
    c.elastic_slip = force.state == ContactState::slip ? -force.shear / spring_ : 0;
    const double slip = force.state == ContactState::slip ? c.elastic_slip : apart.y();
    c.stored_j_per_m = force.state == ContactState::open ? 0 : spring_ * (apart.x() * apart.x() + slip * slip) / 2;
    if (force.state == ContactState::open) return {.block_i = c.vertex_part, .block_j = c.edge_part};
    Interaction action = interaction_of(c, edge, apart.y());
    action.force = c.force;
    action.round_off = progress.round_off;
    const double stiffness = spring_ + dashpot.coefficient * trial.velocity_factor;
    action.stiffness(0, 0) = stiffness;
    if (force.state == ContactState::stick) {
      action.stiffness(1, 1) = stiffness;
    } else {
      action.stiffness(0, 1) = progress_.dilation_slope(c, progress) * stiffness;
      action.stiffness.row(1) = force.shear_per_normal * action.stiffness.row(0);
    }
    return action;
  }

  Interaction support(const Trial& trial, int index, Support& s) override {
    const Progress& progress = progress_.follow(trial, index, s);
    Interaction action = interaction_of(s);
    s.multiplier = s.force = action.force = -spring_ * progress.separation;
    action.round_off = progress.round_off;
    action.stiffness = (spring_ * s.held()).asDiagonal().toDenseMatrix();
    return action;
  }

  /// A spring and a dashpot give way: apart + force / stiffness = 0, apart less what the dashpot had begun with.
  Ruled ruled_contact(const Trial& trial, int index, const ContactPoint& c, const EdgeFrame& edge) override {
    Ruled ruled = Formulation::ruled_contact(trial, index, c, edge);
    const Dashpot& dashpot = dashpots_[at(index)];
    const double stiffness = spring_ + dashpot.coefficient * trial.velocity_factor;
    ruled.rule.compliance.setConstant(1 / stiffness);
    ruled.apart += dashpot.coefficient / stiffness * (dashpot.past_rate - trial.velocity_factor * dashpot.start);
    return ruled;
  }
  Ruled ruled_support(const Trial& trial, int index, const Support& s) override {
    Ruled ruled = Formulation::ruled_support(trial, index, s);
    ruled.rule.compliance.setConstant(1 / spring_);
    return ruled;
  }
  Interaction take_contact(const Trial& trial, int index, ContactPoint& c, const RuledForce& found) override {
    const Interaction action = Formulation::take_contact(trial, index, c, found);
    c.elastic_slip = -found.force.y() / spring_;
    c.stored_j_per_m = found.force.squaredNorm() / (2 * spring_);
    return action;
  }
  [[nodiscard]] double gap_under_force_m(const ContactPoint& c) const override { return -c.force.x() / spring_; }

  bool sweep(const IslandContacts& island) override {
    for (const int k : island.contact_ids) {
      if (progress_.contact(k).turning) return false;
      island.contacts[at(k)].multiplier = island.contacts[at(k)].force;
    }
    return true;
  }

  [[nodiscard]] bool holds_exactly() const override { return false; }

 private:
  struct Dashpot {
    double coefficient = 0;                               ///< N s/m per metre
    Eigen::Vector2d start = Eigen::Vector2d::Zero();      ///< separation at the start of the step [m]
    Eigen::Vector2d past_rate = Eigen::Vector2d::Zero();  ///< of separation, with no further movement [m/s]
  };

  void begin_contact(const Trial& trial, const std::vector<bool>& frozen, int k, ContactPoint& c) override {
    const bool damps = settings_.dashpot_ratio > 0 && trial.velocity_factor > 0;
    c.penalty = spring_;
    dashpots_[at(k)] = damps ? dashpot(trial, frozen, c) : Dashpot{};
  }
  void begin_support(const Trial& /*trial*/, int /*k*/, Support& s) override { s.penalty = spring_; }

  /// The ratio is of the critical damping of the spring with the mass that both blocks put against it, as if they were
  /// rigid and alone: 1/m = n^T M^-1 n over both.
  [[nodiscard]] Dashpot dashpot(const Trial& trial, const std::vector<bool>& frozen, const ContactPoint& c) const {
    const EdgeFrame edge = edge_frame(trial, c);
    const Interaction action = interaction_of(c, edge, 0);
    double inverse_mass = 0;
    Dashpot dashpot{.start = separation_of(trial, c, edge).value};
    const auto add = [&](bool second) {
      const int block = action.block(second);
      const Matrix26 shape = action.shape(trial.placement[at(block)], second);
      const double sign = second ? -1 : 1;
      dashpot.past_rate += sign * (shape * trial.past_velocity[at(block)]);  // a moving base carries fixed blocks too
      if (frozen[at(block)]) return;
      const Inertia& inertia = trial.blocks[at(block)].inertia;
      inverse_mass +=
          shape.row(0).head<2>().squaredNorm() / inertia.mass() + shape(0, 2) * shape(0, 2) / inertia.of_turn();
    };
    add(false);
    add(true);
    if (inverse_mass > 0) dashpot.coefficient = 2 * settings_.dashpot_ratio * std::sqrt(spring_ / inverse_mass);
    return dashpot;
  }

  double spring_;  ///< N/m per metre
  std::vector<Dashpot> dashpots_;
};

}  // namespace

std::unique_ptr<Formulation> make_penalty(const JointLaws& laws, const FormulationSettings& settings) {
  return std::make_unique<Penalty>(laws, settings);
}

}  // namespace blockweir::solid
