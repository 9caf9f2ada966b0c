// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/formulation.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"

namespace blockweir::solid {
namespace {

/// Of one side of a contact.
struct Side {
  double flexibility = 0;
  bool strains = true;
};

/// Resistance at a contact. What does not strain resists by its inertia alone, and a pile of it as weakly: sweep after
/// sweep would be taken to share a load in the pile. So a contact between such blocks counts as so much stiffer, and
/// one with a block that strains is as stiff as that.
double stiffness_between(const Side& one, const Side& other) {
  constexpr double rigid_stiffness_ratio = 1e3;
  if (one.strains != other.strains) return 1 / (one.strains ? one : other).flexibility;
  return (one.strains ? 1 : rigid_stiffness_ratio) / (one.flexibility + other.flexibility);
}

/// By which iterates judge: only forces that have converged open a bond (bonds.cpp).
Strength iterated_strength(const JointLaws& laws, const ContactPoint& c, double normal) {
  Strength strength = laws.strength(c, normal);
  if (!c.let_go && strength.holds_together()) strength.tension = std::numeric_limits<double>::infinity();
  return strength;
}

}  // namespace

std::unique_ptr<Formulation> make_formulation(scene::ContactFormulation which, const JointLaws& laws,
                                              const FormulationSettings& settings) {
  switch (which) {
    case scene::ContactFormulation::penalty:
      return make_penalty(laws, settings);
    case scene::ContactFormulation::lagrange_multiplier:
      return make_lagrange_multiplier(laws, settings);
    case scene::ContactFormulation::augmented_lagrangian:
      break;
  }
  return make_augmented_lagrangian(laws, settings);
}

void Formulation::begin(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
                        const IslandContacts& island) {
  // Rayleigh quotient of the block's matrix along a point's motion, turns and strains taken as what they move at the
  // radius, which makes metres of all: no mode that the point can excite is stiffer by much. (Its inverse counterpart
  // 1/(n W n) sees the softest mode, and sweeps then stall in the stiff ones.)
  const auto flexibility = [&](int block, const Point& axis, const Point& X) {
    if (frozen[at(block)]) return 0.0;
    const auto quotient = [&](auto motion, const auto& k) {
      motion.template tail<motion.RowsAtCompileTime - 2>() /= trial.blocks[at(block)].radius;
      auto pulled = motion;
      pulled.template tail<motion.RowsAtCompileTime - 2>() /= trial.blocks[at(block)].radius;
      return motion.squaredNorm() * motion.squaredNorm() / pulled.dot(k * pulled);
    };
    const Placement& placement = trial.placement[at(block)];
    const Matrix6& k = matrix[at(block)];
    if (!trial.blocks[at(block)].rigid) return quotient(placement.generalized(axis, X), k);
    const double turning = axis.dot(perpendicular(placement.vector(X)));
    return quotient(Eigen::Vector3d(axis.x(), axis.y(), turning), k.topLeftCorner<3, 3>());
  };
  // Stiff contacts have ranges of slip that Newton's method passes by while friction lags.
  const auto side = [&](int block, const Point& axis, const Point& X) {
    const bool strainless = frozen[at(block)] || trial.blocks[at(block)].rigid;
    return Side{flexibility(block, axis, X), settings_.friction_lags || !strainless};
  };
  progress_.make_room(island.contacts.size(), island.supports.size());
  before_.make_room(island.contacts.size(), island.supports.size());
  for_each(island.contact_ids.size(), [&](std::size_t i) {
    const int k = island.contact_ids[i];
    ContactPoint& c = island.contacts[at(k)];
    before_.note(k, c);
    // What a lasting bond has been opened by it pulls at with its strength alone.
    const double opened_m = c.gap - laws_[c.law].dilation_m(c.slip_m);
    const bool stretched =
        settings_.swept && laws_[c.law].keeps_cohesion && opened_m > settings_.penetration_tolerance_m;
    c.let_go = c.state == ContactState::open || stretched;
    Progress& progress = progress_.contact(k) = {};
    const EdgeFrame edge = edge_frame(trial, c);
    if (settings_.lasting_overlap_m > 0) {
      const bool measured = settings_.swept && holds_exactly();
      const double gap = measured ? progress_.follow(trial, k, c, edge).separation.x() : c.overlap_m;
      // What pressed and is off by less than may last stays so: to close it would take energy, or give some.
      const bool pressed = measured && c.state != ContactState::open && gap < settings_.lasting_overlap_m;
      if (pressed || gap < -settings_.lasting_overlap_m) progress.overlap = gap;
    }
    const Point n = edge.n;
    progress.stiffness =
        stiffness_between(side(c.vertex_part, n, c.vertex_at), side(c.edge_part, n, edge_point(c, c.anchor)));
    progress.slip_force = c.multiplier.y();
    begin_contact(trial, frozen, k, c);
  });
  for (const int k : island.support_ids) {
    Support& s = island.supports[at(k)];
    before_.note(k, s);
    Progress& progress = progress_.support(k) = {};
    progress.stiffness =
        2 / (flexibility(s.block, Point::Unit(0), s.material) + flexibility(s.block, Point::Unit(1), s.material));
    begin_support(trial, k, s);
  }
}

Ruled Formulation::ruled_contact(const Trial& trial, int index, const ContactPoint& c, const EdgeFrame& edge) {
  const Progress& progress = progress_.follow(trial, index, c, edge);
  const JointProperties& law = laws_[c.law];
  const Strength strength = iterated_strength(laws_, c, c.force.x());
  // What is left of a bond that has let go holds while sweeps last; where they open the contact it is lost (bonds.cpp).
  const bool for_good = c.let_go && law.keeps_cohesion;
  ForceRule rule{.friction = strength.friction, .cohesion = (for_good ? 0 : strength.cohesion) + strength.intercept};
  if (strength.tension > 0) {
    rule.least_normal = -strength.tension;
    rule.opens = false;
  }
  Eigen::Vector2d apart = progress.separation;
  if (law.dilates()) {  // the slip that the solver finds opens the joint; it goes against the shear
    apart.x() += law.opens_by(c.slip_m, apart.y());
    for (const int side : {0, 1}) rule.opening[at(side)] = -law.dilation_slope(c.slip_m, side == 0 ? 1 : -1);
  }
  return {apart, rule};
}

Ruled Formulation::ruled_support(const Trial& trial, int index, const Support& s) {
  const Point held = s.held();
  ForceRule rule{.opens = false};
  rule.most_normal = held.x() > 0 ? ForceRule::unbounded : 0;
  rule.least_normal = -rule.most_normal;
  rule.cohesion = held.y() > 0 ? ForceRule::unbounded : 0;
  return {progress_.follow(trial, index, s).separation, rule};
}

Interaction Formulation::take_contact(const Trial& trial, int index, ContactPoint& c, const RuledForce& found) {
  const EdgeFrame edge = edge_frame(trial, c);
  Progress& progress = progress_.follow(trial, index, c, edge);
  const bool open = found.force.isZero(0) || iterated_strength(laws_, c, found.force.x()).opens(found.force.x());
  const ContactState state = open ? ContactState::open : found.slips ? ContactState::slip : ContactState::stick;
  progress_.set_state(c, state);
  c.force = c.multiplier = found.force;
  progress.slip_force = found.force.y();
  progress.turning = false;
  progress.swept = !found.exact;
  if (open) return {.block_i = c.vertex_part, .block_j = c.edge_part};
  Interaction action = interaction_of(c, edge, progress.separation.y());
  action.force = c.force;
  return action;
}

Interaction Formulation::take_support(const Trial& trial, int index, Support& s, const Eigen::Vector2d& force) {
  progress_.follow(trial, index, s);
  s.force = s.multiplier = force;
  Interaction action = interaction_of(s);
  action.force = force;
  return action;
}

JointForce Formulation::judge(int index, ContactPoint& c, const Eigen::Vector2d& stuck) {
  Progress& progress = progress_.contact(index);
  const Strength strength = iterated_strength(laws_, c, stuck.x());
  JointForce force;
  const bool states_stand = settings_.states_stand && !laws_[c.law].bonds();
  if (states_stand) {
    force = acting(c.state, strength, stuck.x(), c.state == ContactState::slip ? progress.slip_force : stuck.y());
    progress.turning = false;
  } else if (settings_.joints_held) {
    if (c.state != ContactState::open) force = {ContactState::stick, stuck.x(), stuck.y(), 0};
  } else if (settings_.friction_lags) {
    force = admissible(strength, lagged_.bounds[index], stuck.x(), stuck.y());
    progress.turning = false;
  } else {
    force = admissible(strength, stuck.x(), stuck.y());
    // Slip may not reverse without passing through stick: Newton's method would jump to and fro across the narrow
    // range of slips in which the penalty keeps the shear force within its bounds. A force of nothing has no direction.
    progress.turning = c.state == ContactState::slip && force.state == ContactState::slip && force.shear != 0 &&
                       std::signbit(force.shear) != std::signbit(progress.slip_force);
    if (progress.turning) force = {ContactState::stick, stuck.x(), stuck.y(), 0};
  }
  if (!states_stand) progress.slip_force = force.shear;
  progress.swept = false;
  progress_.set_state(c, force.state);
  c.force = {force.normal, force.shear};
  return force;
}

/// Of a joint's two corners one may bear all: what the other touches without a force it slides along all the same.
bool Formulation::goes_along(const ContactPoint& c, const Progress& progress) const {
  return c.state == ContactState::open && c.has_touched() &&
         std::abs(progress.separation.x()) <= settings_.penetration_tolerance_m;
}

bool Formulation::accept(const Trial& trial, const IslandContacts& island) const {
  std::atomic<bool> any_slips = false;
  for_each(island.contact_ids.size(), [&](std::size_t i) {
    const auto k = at(island.contact_ids[i]);
    ContactPoint& c = island.contacts[k];
    const Progress& progress = progress_.contact(island.contact_ids[i]);
    const double slip = progress.separation.y() - c.elastic_slip;
    // Closed in the step to come, what is left would become a velocity.
    if (c.state == ContactState::stick && progress.swept) c.anchor += slip / edge_frame(trial, c).length;
    if (c.state != ContactState::slip && !goes_along(c, progress)) return;
    any_slips.store(true, std::memory_order_relaxed);
    c.slid = c.slid || c.state == ContactState::slip;
    c.slip_m += slip;
    c.slip_path_m += std::abs(slip);
    c.anchor += slip / edge_frame(trial, c).length;
    if (c.bond > 0) c.bond = std::min(c.bond, laws_[c.law].bond_after(c.slip_path_m));
  });
  return any_slips;
}

}  // namespace blockweir::solid
