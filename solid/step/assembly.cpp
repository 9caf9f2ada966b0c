// SPDX-License-Identifier: GPL-3.0-or-later
// Matrix and residual of one island at the trial (5)-(6): blocks, contacts, supports, bolts, meshes.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {
namespace {

/// A generalized force as a plain one: moments and strain forces over the block's radius [N per metre].
double magnitude(const Vector6& force, const Block& block) {
  const double turning = block.rigid ? std::abs(force[2]) : force.tail<4>().cwiseAbs().maxCoeff();
  return std::max(force.head<2>().cwiseAbs().maxCoeff(), turning / block.radius);
}

}  // namespace

void Solid::prepare_matrices(double dt, const Newmark& scheme) {
  if (dt == matrices_dt_ && scheme == newmark_) return;
  matrices_dt_ = dt;
  newmark_ = scheme;
  for_each(blocks_.size(), [&](std::size_t b) {
    const double velocity_factor = newmark_.velocity_factor(dt);
    const double drag = velocity_factor * scene_.analysis.mass_damping_per_s;
    matrix_[b] = (newmark_.mass_factor(dt) + drag) * blocks_[b].inertia.matrix();
    matrix_[b].bottomRightCorner<3, 3>() += (1 + velocity_factor * retardation_s(b)) * blocks_[b].stiffness;
    if (b < guard_.blocks()) matrix_[b].topLeftCorner<3, 3>() += newmark_.mass_factor(dt) * guard_.mass(b);
  });
}

/// The blocks' own matrices on the diagonal, and what triangles of a mesh share beside it.
template <class System>
void Solid::add_own(System& system, const IslandSystem& s) const {
  for (const int b : s.island.blocks) system.add(local_[at(b)], local_[at(b)], matrix_[at(b)]);
  for (const int k : s.couplings) {
    const StrainCoupling& c = parts_.couplings[at(k)];
    Matrix6 shared = Matrix6::Zero();
    shared.bottomRightCorner<3, 3>() =
        (1 + newmark_.velocity_factor(matrices_dt_) * retardation_s(at(c.i))) * c.stiffness;
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
  add_columns(system, action, false);
  add_columns(system, action, true);
}

/// In the columns of one of both blocks.
template <class System>
void Solid::add_columns(System& system, const Interaction& action, bool of_second) const {
  const int column = action.block(of_second);
  if (!moves(column) || action.stiffness.isZero(0)) return;
  const Matrix26 shape = action.shape(placement_[at(column)], of_second);
  const Matrix26 force = action.stiffness * shape;
  system.add(local_[at(column)], local_[at(column)], shape.transpose() * force);
  const int row = action.block(!of_second);
  if (!moves(row)) return;
  system.add(local_[at(row)], local_[at(column)], -action.shape(placement_[at(row)], !of_second).transpose() * force);
}

/// Forces that are unknowns: their columns and equations.
void Solid::add_constraints(IslandSystem& s, const Interaction& action, bool support, int index) const {
  for (const Constraint& c :
       support ? formulation_->constraints_of_support(index) : formulation_->constraints_of_contact(index)) {
    s.saddle.add_force(c.violation, c.compliance);
    s.unknown_forces.push_back({support, index, c.force});
    for (const bool second : {false, true}) {
      const int block = action.block(second);
      if (!moves(block)) continue;
      const Matrix26 shape = (second ? -1 : 1) * action.shape(placement_[at(block)], second);
      s.saddle.couple(local_[at(block)], shape.transpose() * c.force, shape.transpose() * c.row);
    }
  }
}

/// The matrix that belongs to the residual. Each block takes up its own columns, but where blocks share them.
void Solid::assemble(IslandSystem& s) {
  const Stopwatch watch(profile_.assembly);
  set_block_matrices(s);
  if (s.unknowns->shared()) {
    for (const Interaction& action : s.actions) add_stiffness(*s.system, action);
    return;
  }
  for_each(s.island.blocks.size(), [&](std::size_t k) {
    for (const Incidence::End& end : s.incidence.of(k)) {
      add_columns(*s.system, s.actions[at(end.interaction)], end.second);
    }
  });
}

/// Residual at the trial; returns the largest unbalanced force, less what round-off explains. What contacts, supports
/// and bolts do is kept for the matrix, which only a residual that is too large asks for.
double Solid::unbalanced(IslandSystem& s) {
  const Stopwatch watch(profile_.assembly);
  balance_alone(s);
  let_act(s);
  return find_residual(s, [&](std::size_t k) { take_up(s, k); });
}

/// What acts on an island's blocks without contacts, supports and bolts.
void Solid::balance_alone(IslandSystem& s) {
  if (s.unknowns->shared()) set_corner_maps(s);
  for_each(s.island.blocks.size(), [&](std::size_t k) { balance_own(at(s.island.blocks[k])); });
  balance_couplings(s);
}

/// Of what `also_acts` adds to the balance of each block, by its place in the island.
double Solid::find_residual(IslandSystem& s, const std::function<void(std::size_t)>& also_acts) {
  s.residual.setZero();
  s.uncertain.setZero(s.unknowns->shared() ? s.residual.size() : 0);
  const double unbalanced = largest(s.island.blocks.size(), [&](std::size_t k) {
    if (also_acts) also_acts(k);
    return blocks_[at(s.island.blocks[k])].is_part() ? 0.0 : add_residual(s, k);
  });
  if (!std::isfinite(unbalanced) || !s.unknowns->shared()) return unbalanced;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    if (blocks_[at(s.island.blocks[k])].is_part()) add_residual_at_corners(s, static_cast<int>(k));
  }
  add_mean_inertia(s);
  return std::max(unbalanced, unbalanced_at_nodes(s));
}

/// Loads, elasticity and drag of a block.
void Solid::balance_own(std::size_t b) {
  const Block& block = blocks_[b];
  const Vector6 velocity = newmark_.velocity_factor(matrices_dt_) * increment_[b] + past_velocity_[b];
  Vector6 drag = scene_.analysis.mass_damping_per_s * (block.inertia * velocity);
  drag.tail<3>() += retardation_s(b) * (block.stiffness * velocity.tail<3>());
  balance_[b] = external_[b] - drag;
  balance_[b].tail<3>() -= block.stiffness * (states_[b].displacement + increment_[b]).tail<3>();
  round_off_[b] = sum_round_off * (magnitude(external_[b], block) + magnitude(drag, block));
}

/// What contacts, supports and bolts of an island do at the trial.
void Solid::let_act(IslandSystem& s) {
  const Stopwatch watch(profile_.contact);
  std::atomic<bool> symmetric = true;
  const auto keep = [&](std::size_t k, const Interaction& action) {
    s.actions[k] = action;
    if (action.stiffness(1, 0) != action.stiffness(0, 1)) symmetric.store(false, std::memory_order_relaxed);
  };
  const Trial now = trial();
  const std::vector<int>& contacts = s.island.contacts;
  const std::vector<int>& supports = s.island.supports;
  const std::size_t of_bolts = contacts.size() + supports.size();
  s.actions.resize(of_bolts + s.bolts.size());
  for_each(contacts.size(),
           [&](std::size_t i) { keep(i, formulation_->contact(now, contacts[i], contacts_[at(contacts[i])])); });
  for (std::size_t i = 0; i < supports.size(); ++i) {
    keep(contacts.size() + i, formulation_->support(now, supports[i], supports_[at(supports[i])]));
  }
  for (std::size_t i = 0; i < s.bolts.size(); ++i) {
    keep(of_bolts + i, interaction_of(now, bolts_[at(s.bolts[i])], base_.displacement(end_s_)));
  }
  s.symmetric = symmetric;

  s.unknown_forces.clear();
  if (!formulation_->solves_for_forces()) return;
  s.saddle.set_zero();
  for (std::size_t k = 0; k < of_bolts; ++k) {
    const bool support = k >= contacts.size();
    add_constraints(s, s.actions[k], support, support ? supports[k - contacts.size()] : contacts[k]);
  }
  if (s.unknown_forces.empty()) return;
  add_own(s.saddle, s);
  for (std::size_t i = 0; i < s.bolts.size(); ++i) add_stiffness(s.saddle, s.actions[of_bolts + i]);
  add_mean_inertia_to_saddle(s);
}

/// Adds to the balance of an island's block k what acts on it.
void Solid::take_up(const IslandSystem& s, std::size_t k) {
  const auto b = at(s.island.blocks[k]);
  for (const Incidence::End& end : s.incidence.of(k)) {
    const Interaction& action = s.actions[at(end.interaction)];
    if (action.force.isZero(0)) continue;
    const Vector6 force = placement_[b].generalized((end.second ? -1 : 1) * action.pull(), action.at(end.second));
    balance_[b] += force;
    round_off_[b] += sum_round_off * magnitude(force, blocks_[b]) + action.round_off;
  }
}

/// Of an island's block k: balance less inertia. Returns the unbalanced force, less what round-off explains.
double Solid::add_residual(IslandSystem& s, std::size_t k) {
  const double mass_factor = newmark_.mass_factor(matrices_dt_);
  const auto b = at(s.island.blocks[k]);
  Vector6 inertia = mass_factor * (blocks_[b].inertia * increment_[b]);
  if (b < guard_.blocks()) inertia.head<3>() += mass_factor * (guard_.mass(b) * increment_[b].head<3>());
  const Vector6 residual = balance_[b] - inertia + history_[b];
  s.unknowns->add(static_cast<int>(k), residual, s.residual);
  const double noise =
      round_off_[b] + sum_round_off * (magnitude(inertia, blocks_[b]) + magnitude(history_[b], blocks_[b]));
  const double force = magnitude(residual, blocks_[b]);
  return std::isfinite(force) ? std::max(0.0, force - noise) : force;
}

template void Solid::add_stiffness(LinearSystem& system, const Interaction& action) const;

}  // namespace blockweir::solid
