// SPDX-License-Identifier: GPL-3.0-or-later
// Matrix and residual of one island at the trial (5)-(6): blocks, contacts, supports, bolts, meshes.
#include <algorithm>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {
namespace {

constexpr double round_off = 1e-13;  // relative, of a sum of some tens of terms

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// A generalized force as a plain one: moments and strain forces over the block's radius [N per metre].
double magnitude(const Vector6& force, const Block& block) {
  const double turning = force.segment(2, block.unknowns() - 2).cwiseAbs().maxCoeff();
  return std::max(force.head<2>().cwiseAbs().maxCoeff(), turning / block.radius);
}

}  // namespace

void Solid::prepare_matrices(double dt) {
  if (dt == matrices_dt_) return;
  matrices_dt_ = dt;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    matrix_[b] = newmark_.mass_factor(dt) * blocks_[b].mass + blocks_[b].stiffness +
                 newmark_.velocity_factor(dt) * blocks_[b].damping;
    if (b < guard_.blocks()) matrix_[b].topLeftCorner<3, 3>() += newmark_.mass_factor(dt) * guard_.mass(b);
  }
}

/// The blocks' own matrices on the diagonal, and what triangles of a mesh share beside it.
template <class System>
void Solid::add_own(System& system, const IslandSystem& s) const {
  for (const int b : s.island.blocks) system.add(local_[at(b)], local_[at(b)], matrix_[at(b)]);
  for (const int k : s.couplings) {
    const StrainCoupling& c = parts_.couplings[at(k)];
    Matrix6 shared = Matrix6::Zero();
    shared.bottomRightCorner<3, 3>() = (1 + newmark_.velocity_factor(matrices_dt_) * c.retardation_s) * c.stiffness;
    system.add(local_[at(c.i)], local_[at(c.j)], shared);
    system.add(local_[at(c.j)], local_[at(c.i)], shared);
  }
}

void Solid::set_block_matrices(IslandSystem& s) {
  s.system->set_zero();
  add_own(*s.system, s);
}

/// What a contact or support adds to the matrix: J^T C J on the diagonal of each block, -J^T C J between the two.
template <class System>
void Solid::add_stiffness(System& system, const Interaction& action) const {
  const auto moves = [this](int block) { return block >= 0 && !frozen_[at(block)]; };
  const auto add = [&](int row, const Matrix26& row_shape, int column, const Matrix26& column_shape, double sign) {
    if (!moves(row) || !moves(column)) return;
    system.add(local_[at(row)], local_[at(column)], sign * row_shape.transpose() * action.stiffness * column_shape);
  };
  add(action.block_i, action.shape_i, action.block_i, action.shape_i, 1);
  add(action.block_j, action.shape_j, action.block_j, action.shape_j, 1);
  add(action.block_i, action.shape_i, action.block_j, action.shape_j, -1);
  add(action.block_j, action.shape_j, action.block_i, action.shape_i, -1);
}

/// Forces that are unknowns: their columns and equations.
void Solid::add_constraints(IslandSystem& s, const Interaction& action, bool support, int index) const {
  for (int i = 0; i < action.constraint_count; ++i) {
    const Constraint& c = action.constraints[at(i)];
    s.saddle.add_force(c.violation, c.compliance);
    s.unknown_forces.push_back({support, index, c.force});
    const auto couple = [&](int block, const Matrix26& shape, double sign) {
      if (block < 0 || frozen_[at(block)]) return;
      s.saddle.couple(local_[at(block)], sign * (shape.transpose() * c.force), sign * (shape.transpose() * c.row));
    };
    couple(action.block_i, action.shape_i, 1);
    couple(action.block_j, action.shape_j, -1);
  }
}

/// The matrix that belongs to the residual.
void Solid::assemble(IslandSystem& s) {
  const Stopwatch watch(profile_.assembly);
  set_block_matrices(s);
  for (const Interaction& action : s.actions) {
    if (action.constraint_count == 0) add_stiffness(*s.system, action);
  }
}

/// Residual at the trial; returns the largest unbalanced force, less what round-off explains. What contacts, supports
/// and bolts do is kept for the matrix, which only a residual that is too large asks for.
double Solid::unbalanced(IslandSystem& s) {
  const Stopwatch watch(profile_.assembly);
  const double mass_factor = newmark_.mass_factor(matrices_dt_);
  if (s.unknowns->shared()) set_corner_maps(s);
  for (const int block : s.island.blocks) {
    const auto b = at(block);
    const Vector6 velocity = newmark_.velocity_factor(matrices_dt_) * increment_[b] + past_velocity_[b];
    const Vector6 drag = blocks_[b].damping * velocity;
    balance_[b] = external_[b] - blocks_[b].stiffness * (states_[b].displacement + increment_[b]) - drag;
    round_off_[b] = round_off * (magnitude(external_[b], blocks_[b]) + magnitude(drag, blocks_[b]));
  }
  balance_couplings(s);

  s.saddle.set_zero();
  s.unknown_forces.clear();
  s.actions.clear();
  s.symmetric = true;
  const auto add = [&](const Interaction& action, bool support, int index) {
    if (!action.acts()) return;
    const auto side = [&](int block, const Matrix26& shape, double sign) {
      if (block < 0 || frozen_[at(block)]) return;
      const Vector6 force = sign * (shape.transpose() * action.force);
      balance_[at(block)] += force;
      round_off_[at(block)] += round_off * magnitude(force, blocks_[at(block)]) + action.round_off;
    };
    side(action.block_i, action.shape_i, 1);
    side(action.block_j, action.shape_j, -1);
    s.actions.push_back(action);
    if (action.constraint_count > 0) return add_constraints(s, action, support, index);
    s.symmetric = s.symmetric && action.stiffness(1, 0) == action.stiffness(0, 1);
  };
  std::vector<Interaction> bolts;
  {
    const Stopwatch of_contact(profile_.contact);
    for (const int k : s.island.contacts) add(formulation_->contact(trial(), k, contacts_[at(k)]), false, k);
    for (const int k : s.island.supports) add(formulation_->support(trial(), k, supports_[at(k)]), true, k);
    for (const int k : s.bolts) bolts.push_back(interaction_of(trial(), bolts_[at(k)], base_.displacement(end_s_)));
    for (const Interaction& bolt : bolts) add(bolt, false, -1);
  }
  if (!s.unknown_forces.empty()) {
    add_own(s.saddle, s);
    for (const Interaction& bolt : bolts) add_stiffness(s.saddle, bolt);
    add_mean_inertia_to_saddle(s);
  }

  double unbalanced = 0;
  s.residual.setZero();
  s.uncertain.setZero(s.residual.size());
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    const auto b = at(s.island.blocks[k]);
    if (blocks_[b].is_part()) {
      add_residual_at_corners(s, static_cast<int>(k));
      continue;
    }
    Vector6 inertia = mass_factor * (blocks_[b].mass * increment_[b]);
    if (b < guard_.blocks()) inertia.head<3>() += mass_factor * (guard_.mass(b) * increment_[b].head<3>());
    const Vector6 residual = balance_[b] - inertia + history_[b];
    s.unknowns->add(static_cast<int>(k), residual, s.residual);
    const double noise =
        round_off_[b] + round_off * (magnitude(inertia, blocks_[b]) + magnitude(history_[b], blocks_[b]));
    const double force = magnitude(residual, blocks_[b]);
    unbalanced = std::isfinite(force) ? std::max(unbalanced, force - noise) : force;
    if (!std::isfinite(unbalanced)) return unbalanced;
  }
  add_mean_inertia(s);
  return std::max(unbalanced, unbalanced_at_nodes(s));
}

template void Solid::add_stiffness(LinearSystem& system, const Interaction& action) const;

}  // namespace blockweir::solid
