// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/augmented_lagrangian.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::solid {
namespace {

// Penalties in units of the blocks' own stiffness at the contact: a sweep shrinks the gap to 1/(1 + ratio); much
// larger ratios cost digits in the factorization.
constexpr double largest_penalty_ratio = 1e6;
constexpr double epsilon = 4 * std::numeric_limits<double>::epsilon();

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Edge of a contact at the trial: unit tangent, outward normal, material point under the vertex.
struct EdgeFrame {
  Point t;
  Point n;
  double length = 0;
};

EdgeFrame edge_frame(const Trial& trial, const ContactPoint& c) {
  const auto& vertices = trial.blocks[at(c.edge_block)].vertices;
  const Point& a = vertices[at(c.edge)];
  const Point& b = vertices[(at(c.edge) + 1) % vertices.size()];
  const Point span = trial.placement[at(c.edge_block)].vector(b - a);
  const double length = span.norm();
  const Point t = span / length;
  return {t, Point(t.y(), -t.x()), length};
}

Point edge_point(const Trial& trial, const ContactPoint& c, double fraction) {
  const auto& vertices = trial.blocks[at(c.edge_block)].vertices;
  const Point& a = vertices[at(c.edge)];
  const Point& b = vertices[(at(c.edge) + 1) % vertices.size()];
  return a + fraction * (b - a);
}

const Point& vertex_point(const Trial& trial, const ContactPoint& c) {
  return trial.blocks[at(c.vertex_block)].vertices[at(c.vertex)];
}

Matrix26 rows(const Matrix26& T, const Point& n, const Point& t) {
  Matrix26 J;
  J.row(0) = n.transpose() * T;
  J.row(1) = t.transpose() * T;
  return J;
}

}  // namespace

double AugmentedLagrangian::bounded_penalty(double kept, double stiffness) const {
  const double initial = settings_.initial_penalty.value_or(settings_.penalty_ratio * stiffness);
  return std::min(kept > 0 ? kept : initial, settings_.penalty_ratio * stiffness);
}

void AugmentedLagrangian::begin_step(const Trial& trial, const std::vector<Matrix6>& matrix,
                                     const std::vector<bool>& frozen, std::vector<ContactPoint>& contacts,
                                     std::vector<Support>& supports) {
  // Rayleigh quotient of the block's matrix along a point's motion: no mode that the point can excite is stiffer
  // by much. (Its inverse counterpart 1/(n W n) sees the softest mode, and sweeps then stall in the stiff ones.)
  const auto flexibility = [&](int block, const Eigen::Matrix<double, 1, 6>& motion) {
    if (frozen[at(block)]) return 0.0;
    return motion.squaredNorm() * motion.squaredNorm() / motion.dot(matrix[at(block)] * motion.transpose());
  };
  contacts_.assign(contacts.size(), {});
  supports_.assign(supports.size(), {});
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    ContactPoint& c = contacts[k];
    const Point n = edge_frame(trial, c).n;
    const Matrix26 Tv = trial.placement[at(c.vertex_block)].shape(vertex_point(trial, c));
    const Matrix26 Te = trial.placement[at(c.edge_block)].shape(edge_point(trial, c, c.anchor));
    contacts_[k].stiffness =
        1 / (flexibility(c.vertex_block, n.transpose() * Tv) + flexibility(c.edge_block, n.transpose() * Te));
    c.penalty = bounded_penalty(c.penalty, contacts_[k].stiffness);
    contacts_[k].slip_force = c.multiplier.y();
  }
  for (std::size_t k = 0; k < supports.size(); ++k) {
    Support& s = supports[k];
    const Matrix26 T = trial.placement[at(s.block)].shape(s.material);
    supports_[k].stiffness = 2 / (flexibility(s.block, T.row(0)) + flexibility(s.block, T.row(1)));
    s.penalty = bounded_penalty(s.penalty, supports_[k].stiffness);
  }
}

Strength AugmentedLagrangian::strength(const ContactPoint& c) const {
  const JointProperties& law = laws_[c.law];
  if (!c.bonded) return {.friction = law.residual_friction};
  return {
      .friction = law.friction, .cohesion = law.cohesion_pa * c.bond_length, .tension = law.tension_pa * c.bond_length};
}

Interaction AugmentedLagrangian::contact(const Trial& trial, int index, ContactPoint& c) {
  const EdgeFrame edge = edge_frame(trial, c);
  const Placement& start_v = trial.start[at(c.vertex_block)];
  const Placement& start_e = trial.start[at(c.edge_block)];
  const Point vertex_moved = start_v.increment(trial.increment[at(c.vertex_block)], vertex_point(trial, c));
  const Point edge_moved = start_e.increment(trial.increment[at(c.edge_block)], edge_point(trial, c, c.anchor));
  const Point apart = c.separation + vertex_moved - edge_moved;
  Progress& progress = contacts_[at(index)];
  progress.separation = {edge.n.dot(apart), edge.t.dot(apart)};

  progress.round_off = epsilon * c.penalty * (vertex_moved.norm() + edge_moved.norm());

  const Point raw = c.multiplier - c.penalty * progress.separation;
  JointForce force;
  if (settings_.joints_held) {
    if (c.state != ContactState::open) force = {ContactState::stick, raw.x(), raw.y(), 0};
  } else {
    force = admissible(strength(c), raw.x(), raw.y());
    // Slip may not reverse without passing through stick: Newton's method would jump to and fro across the narrow
    // range of slips in which the penalty keeps the shear force within its bounds.
    progress.turning = c.state == ContactState::slip && force.state == ContactState::slip &&
                       std::signbit(force.shear) != std::signbit(progress.slip_force);
    if (progress.turning) force = {ContactState::stick, raw.x(), raw.y(), 0};
  }
  progress.slip_force = force.shear;
  if (force.state != c.state) ++state_changes_;
  c.state = force.state;
  progress.force = {force.normal, force.shear};
  c.force = progress.force;
  progress.violated = {force.state == ContactState::open ? 0 : progress.separation.x(),
                       force.state == ContactState::stick ? progress.separation.y() : 0};

  Interaction action;
  action.block_i = c.vertex_block;
  action.block_j = c.edge_block;
  if (force.state == ContactState::open) return action;
  const double foot = c.anchor + progress.separation.y() / edge.length;
  action.shape_i = rows(trial.placement[at(c.vertex_block)].shape(vertex_point(trial, c)), edge.n, edge.t);
  action.shape_j = rows(trial.placement[at(c.edge_block)].shape(edge_point(trial, c, foot)), edge.n, edge.t);
  action.force = progress.force;
  action.round_off = progress.round_off;
  action.stiffness(0, 0) = c.penalty;
  if (force.state == ContactState::stick) action.stiffness(1, 1) = c.penalty;
  if (force.state == ContactState::slip) action.stiffness(1, 0) = force.shear_per_normal * c.penalty;
  return action;
}

Interaction AugmentedLagrangian::support(const Trial& trial, int index, Support& s) {
  Progress& progress = supports_[at(index)];
  const Point held = s.held();
  const Point moved = trial.start[at(s.block)].increment(trial.increment[at(s.block)], s.material);
  progress.separation = held.cwiseProduct(s.separation + moved);
  progress.round_off = epsilon * s.penalty * moved.norm();
  progress.violated = progress.separation;
  progress.force = s.multiplier - s.penalty * progress.separation;
  Interaction action;
  action.block_i = s.block;
  action.shape_i = trial.placement[at(s.block)].shape(s.material);
  action.force = progress.force;
  action.round_off = progress.round_off;
  action.stiffness = s.penalty * held.asDiagonal().toDenseMatrix();
  return action;
}

bool AugmentedLagrangian::settled(const Progress& p, const Eigen::Vector2d& multiplier) const {
  const double violation = p.violated.cwiseAbs().maxCoeff();
  return !p.turning && violation <= settings_.penetration_tolerance_m &&
         (violation <= settings_.position_round_off_m ||
          (p.force - multiplier).cwiseAbs().maxCoeff() <= settings_.force_tolerance_n + p.round_off);
}

void AugmentedLagrangian::raise_if_slow(Progress& progress, double& penalty) const {
  const double violation = progress.violated.cwiseAbs().maxCoeff();
  if (4 * violation > progress.last_violation) {
    penalty = std::min(10 * penalty, largest_penalty_ratio * progress.stiffness);
  }
  progress.last_violation = violation;
}

bool AugmentedLagrangian::sweep(const std::vector<int>& contact_ids, std::vector<ContactPoint>& contacts,
                                const std::vector<int>& support_ids, std::vector<Support>& supports) {
  const auto one = [this](Progress& progress, Eigen::Vector2d& multiplier, double& penalty) {
    // A settled multiplier stays: where contacts are redundant, gaps of round-off size would add up in it.
    if (settled(progress, multiplier)) return true;
    raise_if_slow(progress, penalty);
    multiplier = progress.force;
    return false;
  };
  bool all_settled = true;
  for (const int k : contact_ids) {
    ContactPoint& c = contacts[at(k)];
    if (c.state == ContactState::open) {
      // No force is left to remember; only a contact that a negative multiplier held open may still have to close.
      all_settled &= c.multiplier.x() >= 0 || contacts_[at(k)].separation.x() >= 0;
      c.multiplier.setZero();
      continue;
    }
    all_settled &= one(contacts_[at(k)], c.multiplier, c.penalty);
  }
  for (const int k : support_ids) {
    all_settled &= one(supports_[at(k)], supports[at(k)].multiplier, supports[at(k)].penalty);
  }
  return all_settled;
}

bool AugmentedLagrangian::break_bonds(const std::vector<int>& contact_ids, std::vector<ContactPoint>& contacts) const {
  if (settings_.joints_held) return false;
  const auto brittle = [&](const ContactPoint& c) { return c.bonded && !laws_[c.law].keeps_cohesion; };
  const auto joint = [](const ContactPoint& c) { return std::minmax(c.vertex_block, c.edge_block); };
  const auto held = [&](const ContactPoint& slipping) {
    return std::any_of(contact_ids.begin(), contact_ids.end(), [&](int k) {
      const ContactPoint& c = contacts[at(k)];
      return c.state == ContactState::stick && brittle(c) && joint(c) == joint(slipping);
    });
  };
  bool broken = false;
  for (const int k : contact_ids) {
    ContactPoint& c = contacts[at(k)];
    if (!brittle(c) || c.state == ContactState::stick || (c.state == ContactState::slip && held(c))) continue;
    c.bonded = false;
    broken = true;
  }
  return broken;
}

void AugmentedLagrangian::accept(const Trial& trial, std::vector<ContactPoint>& contacts) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    ContactPoint& c = contacts[k];
    if (c.state != ContactState::slip) continue;
    const double slip = contacts_[k].separation.y();
    c.slip_m += slip;
    c.anchor += slip / edge_frame(trial, c).length;
  }
}

}  // namespace blockweir::solid
