// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of one island at the end of a step: Newton's method on (5)-(6) with the open-close states inside,
// multipliers swept (8) each time it has converged.
#include <algorithm>
#include <cmath>

#include "solid/step/solid.hpp"
#include "solid/step/stopwatch.hpp"

namespace blockweir::solid {
namespace {

constexpr double round_off = 1e-13;  // relative, of a sum of some tens of terms

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// A generalized force as a plain one: moments and strain forces over the block's radius [N per metre].
double magnitude(const Vector6& force, double radius) {
  return std::max(force.head<2>().cwiseAbs().maxCoeff(), force.tail<4>().cwiseAbs().maxCoeff() / radius);
}

}  // namespace

void Solid::prepare_matrices(double dt) {
  if (dt == matrices_dt_) return;
  matrices_dt_ = dt;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    matrix_[b] = newmark_.mass_factor(dt) * blocks_[b].mass + blocks_[b].stiffness +
                 newmark_.velocity_factor(dt) * blocks_[b].damping;
  }
}

/// Islands, and with them the symbolic factorizations, are kept while the contact graph stands.
void Solid::prepare_islands() {
  const Stopwatch watch(profile_.search);
  std::vector<std::pair<int, int>> links;
  for (const ContactPoint& c : contacts_) links.emplace_back(c.vertex_block, c.edge_block);
  if (links == links_ && !islands_.empty()) return;
  links_ = std::move(links);
  std::vector<int> support_blocks;
  for (const Support& s : supports_) support_blocks.push_back(s.block);
  islands_.clear();
  for (Island& island : find_islands(frozen_, links_, support_blocks)) {
    IslandSystem system;
    system.system = make_linear_system(static_cast<int>(island.blocks.size()), island.couples);
    system.residual.resize(static_cast<Eigen::Index>(6 * island.blocks.size()));
    system.correction.resize(system.residual.size());
    system.island = std::move(island);
    islands_.push_back(std::move(system));
  }
}

bool Solid::find_equilibrium(IslandSystem& s) {
  bool swept = false;  // multipliers have changed since the last solve
  for (int iteration = 0; iteration < scene_.contact.max_iterations; ++iteration) {
    bool symmetric = true;
    const double unbalanced = assemble(s, symmetric);
    if (!std::isfinite(unbalanced)) return false;
    if (!swept && unbalanced <= lagrangian_.settings().force_tolerance_n) {
      ++counts_.sweeps;
      if (lagrangian_.sweep(s.island.contacts, contacts_, s.island.supports, supports_) &&
          !lagrangian_.break_bonds(s.island.contacts, contacts_)) {
        return true;
      }
      swept = true;
      continue;
    }
    swept = false;
    const Stopwatch watch(profile_.solve);
    if (!s.system->solve(symmetric, s.residual, s.correction)) return false;
    ++counts_.iterations;
    for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
      const auto b = at(s.island.blocks[k]);
      increment_[b] += s.correction.segment<6>(static_cast<Eigen::Index>(6 * k));
      placement_[b] = Placement(blocks_[b].centroid, states_[b].displacement + increment_[b]);
    }
  }
  return false;
}

/// The blocks' own matrices on the diagonal.
void Solid::set_block_matrices(IslandSystem& s) {
  s.system->set_zero();
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    const auto b = at(s.island.blocks[k]);
    local_[b] = static_cast<int>(k);
    s.system->add(local_[b], local_[b], matrix_[b]);
  }
}

/// What a contact or support adds to the matrix: J^T C J on the diagonal of each block, -J^T C J between the two.
void Solid::add_stiffness(LinearSystem& system, const Interaction& action) const {
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

/// Velocities along held directions (closed contacts, sticking ones along the edge too, supports) become the mean of
/// the step: the velocities get the smallest change, in the metric of the step's matrix, that does so. Friction of a
/// slipping contact has no part in it: with that coupling the projection could grow what it should remove.
void Solid::quiet_held_directions(IslandSystem& s, double dt) {
  constexpr double unheard_m_per_s = 1e-9;
  double loudest = 0;
  const auto mismatch = [&](int block, const Matrix26& shape) -> Eigen::Vector2d {
    if (block < 0 || frozen_[at(block)]) return Eigen::Vector2d::Zero();
    return shape * (increment_[at(block)] / dt - states_[at(block)].velocity);
  };
  std::vector<Interaction> actions;
  for (const int k : s.island.contacts) actions.push_back(lagrangian_.contact(trial(), k, contacts_[at(k)]));
  for (const int k : s.island.supports) actions.push_back(lagrangian_.support(trial(), k, supports_[at(k)]));
  std::vector<Eigen::Vector2d> pull(actions.size(), Eigen::Vector2d::Zero());
  for (std::size_t k = 0; k < actions.size(); ++k) {
    const Interaction& a = actions[k];
    if (!a.acts()) continue;
    const Eigen::Vector2d m = mismatch(a.block_i, a.shape_i) - mismatch(a.block_j, a.shape_j);
    for (int axis = 0; axis < 2; ++axis) {
      pull[k][axis] = a.stiffness(axis, axis) * m[axis];
      if (a.stiffness(axis, axis) > 0) loudest = std::max(loudest, std::abs(m[axis]));
    }
  }
  if (loudest <= unheard_m_per_s) return;

  set_block_matrices(s);
  s.residual.setZero();
  for (std::size_t k = 0; k < actions.size(); ++k) {
    Interaction& a = actions[k];
    if (!a.acts()) continue;
    a.stiffness = a.stiffness.diagonal().asDiagonal().toDenseMatrix();
    add_stiffness(*s.system, a);
    if (!frozen_[at(a.block_i)]) s.residual.segment<6>(6 * local_[at(a.block_i)]) += a.shape_i.transpose() * pull[k];
    if (a.block_j >= 0 && !frozen_[at(a.block_j)]) {
      s.residual.segment<6>(6 * local_[at(a.block_j)]) -= a.shape_j.transpose() * pull[k];
    }
  }
  if (!s.system->solve(/*symmetric=*/true, s.residual, s.correction)) return;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    states_[at(s.island.blocks[k])].velocity += s.correction.segment<6>(static_cast<Eigen::Index>(6 * k));
  }
}

/// Matrix and residual at the trial; returns the largest unbalanced force, less what round-off explains.
double Solid::assemble(IslandSystem& s, bool& symmetric) {
  const Stopwatch watch(profile_.assembly);
  const double mass_factor = newmark_.mass_factor(matrices_dt_);
  const auto count = static_cast<int>(s.island.blocks.size());
  set_block_matrices(s);
  for (const int block : s.island.blocks) {
    const auto b = at(block);
    const Vector6 velocity =
        newmark_.velocity_factor(matrices_dt_) * increment_[b] + newmark_.past_velocity(states_[b], matrices_dt_);
    const Vector6 drag = blocks_[b].damping * velocity;
    balance_[b] = external_[b] - blocks_[b].stiffness * (states_[b].displacement + increment_[b]) - drag;
    round_off_[b] = round_off * (magnitude(external_[b], blocks_[b].radius) + magnitude(drag, blocks_[b].radius));
  }

  const auto add = [&](const Interaction& action) {
    if (!action.acts()) return;
    symmetric = symmetric && action.stiffness(1, 0) == action.stiffness(0, 1);
    const auto side = [&](int block, const Matrix26& shape, double sign) {
      if (block < 0 || frozen_[at(block)]) return;
      const Vector6 force = sign * (shape.transpose() * action.force);
      balance_[at(block)] += force;
      round_off_[at(block)] += round_off * magnitude(force, blocks_[at(block)].radius) + action.round_off;
    };
    side(action.block_i, action.shape_i, 1);
    side(action.block_j, action.shape_j, -1);
    add_stiffness(*s.system, action);
  };
  for (const int k : s.island.contacts) add(lagrangian_.contact(trial(), k, contacts_[at(k)]));
  for (const int k : s.island.supports) add(lagrangian_.support(trial(), k, supports_[at(k)]));

  double unbalanced = 0;
  for (int k = 0; k < count; ++k) {
    const auto b = at(s.island.blocks[at(k)]);
    const Vector6 inertia = mass_factor * (blocks_[b].mass * increment_[b]);
    const Vector6 residual = balance_[b] - inertia + history_[b];
    s.residual.segment<6>(6 * k) = residual;
    const double noise =
        round_off_[b] + round_off * (magnitude(inertia, blocks_[b].radius) + magnitude(history_[b], blocks_[b].radius));
    const double force = magnitude(residual, blocks_[b].radius);
    unbalanced = std::isfinite(force) ? std::max(unbalanced, force - noise) : force;
    if (!std::isfinite(unbalanced)) break;
  }
  return unbalanced;
}

}  // namespace blockweir::solid
