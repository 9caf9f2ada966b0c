// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of one island at the end of a step: Newton's method on (5)-(6) with the open-close states inside,
// multipliers swept (8) each time it has converged.
#include <algorithm>
#include <cmath>

#include "solid/solve/condition_number.hpp"
#include "solid/step/solid.hpp"
#include "solid/step/stopwatch.hpp"

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
  }
}

/// Islands, and with them the symbolic factorizations, are kept while the contact graph stands.
void Solid::prepare_islands() {
  const Stopwatch watch(profile_.search);
  std::vector<std::pair<int, int>> links;
  for (const ContactPoint& c : contacts_) links.emplace_back(c.vertex_part, c.edge_part);
  for (const Bolt& bolt : bolts_) {
    if (bolt.part[1] >= 0 && !frozen_[at(bolt.part[0])] && !frozen_[at(bolt.part[1])]) {
      links.emplace_back(bolt.part[0], bolt.part[1]);
    }
  }
  if (links == links_ && !islands_.empty()) return;
  links_ = std::move(links);
  std::vector<int> support_blocks;
  for (const Support& s : supports_) support_blocks.push_back(s.block);
  std::vector<std::pair<int, int>> joined;
  for (const StrainCoupling& c : parts_.couplings) joined.emplace_back(c.i, c.j);
  islands_.clear();
  std::vector<std::size_t> island_of(blocks_.size());
  std::vector<Island> found = find_islands(frozen_, links_, support_blocks, joined);
  if (!scene_.analysis.islands) found = {join(found)};
  for (Island& island : found) {
    std::vector<int> counts;
    std::vector<std::array<int, 3>> nodes;
    for (const int b : island.blocks) {
      counts.push_back(blocks_[at(b)].unknowns());
      nodes.push_back(blocks_[at(b)].nodes);
      island_of[at(b)] = islands_.size();
    }
    islands_.emplace_back(std::move(island), std::make_unique<Unknowns>(counts, nodes));
  }
  for (std::size_t c = 0; c < parts_.couplings.size(); ++c) {
    const auto part = at(parts_.couplings[c].i);
    if (!frozen_[part]) islands_[island_of[part]].couplings.push_back(static_cast<int>(c));
  }
  give_bolts_to_islands();
}

/// Links beyond those of contacts were bolts' own; a bolt belongs to the island of what moves at its ends.
void Solid::give_bolts_to_islands() {
  const auto contacts = static_cast<int>(contacts_.size());
  std::vector<std::size_t> island_of(blocks_.size(), islands_.size());
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    std::erase_if(islands_[i].island.contacts, [&](int k) { return k >= contacts; });
    for (const int b : islands_[i].island.blocks) island_of[at(b)] = i;
  }
  for (std::size_t k = 0; k < bolts_.size(); ++k) {
    for (const int b : bolts_[k].part) {
      if (b < 0 || island_of[at(b)] == islands_.size()) continue;
      islands_[island_of[at(b)]].bolts.push_back(static_cast<int>(k));
      break;
    }
  }
}

bool Solid::find_equilibrium(IslandSystem& s) {
  bool swept = false;  // multipliers have changed since the last solve
  for (int iteration = 0; iteration < scene_.contact.max_iterations; ++iteration) {
    bool symmetric = true;
    const double unbalanced = assemble(s, symmetric);
    if (!std::isfinite(unbalanced)) {
      require_numbers(s);
      return false;
    }
    if (!swept && unbalanced <= formulation_->settings().force_tolerance_n) {
      ++counts_.sweeps;
      if (formulation_->sweep({s.island.contacts, contacts_, s.island.supports, supports_}) &&
          (formulation_->settings().joints_held || !break_bonds(laws_, s.island.contacts, contacts_))) {
        return true;
      }
      swept = true;
      continue;
    }
    swept = false;
    if (!correct(s, symmetric)) return false;
  }
  return false;
}

/// One solution of the linearized equations, added to the trial.
bool Solid::correct(IslandSystem& s, bool symmetric) {
  const Stopwatch watch(profile_.solve);
  if (s.unknown_forces.empty()) {
    if (!s.system->solve(symmetric, s.residual, s.correction)) return false;
  } else {
    if (!s.saddle.solve(s.residual, s.correction, s.forces)) return false;
    correct_forces(s);
  }
  ++counts_.iterations;
  if (scene_.contact.measure_condition) {
    counts_.condition_number = std::max(
        counts_.condition_number, condition_number(s.unknown_forces.empty() ? s.system->dense() : s.saddle.dense()));
  }
  for (const auto& [node, first] : s.unknowns->nodes) node_increment_[at(node)] += s.correction.segment<2>(first);
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    const auto b = at(s.island.blocks[k]);
    if (blocks_[b].is_part()) {
      follow_corners(b);
      continue;
    }
    increment_[b] += s.unknowns->take(static_cast<int>(k), s.correction);
    placement_[b] = Placement(blocks_[b].centroid, states_[b].displacement + increment_[b]);
  }
  return true;
}

void Solid::correct_forces(IslandSystem& s) {
  std::size_t next = 0;  // of the unknown forces; those of a contact or support follow each other
  const auto force_of = [&](bool support, int index) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (; next < s.unknown_forces.size(); ++next) {
      const UnknownForce& unknown = s.unknown_forces[next];
      if (unknown.support != support || unknown.index != index) break;
      sum += s.forces[static_cast<Eigen::Index>(next)] * unknown.force;
    }
    return sum;
  };
  for (const int k : s.island.contacts) formulation_->correct_contact(k, contacts_[at(k)], force_of(false, k));
  for (const int k : s.island.supports) formulation_->correct_support(k, supports_[at(k)], force_of(true, k));
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
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) local_[at(s.island.blocks[k])] = static_cast<int>(k);
  if (s.unknowns->shared()) set_corner_maps(s);
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

/// Velocities along held directions (closed contacts, sticking ones along the edge too, supports) become the mean of
/// the step: the velocities get the smallest change, in the metric of the step's matrix, that does so. Friction of a
/// slipping contact has no part in it: with that coupling the projection could grow what it should remove.
void Solid::quiet_held_directions(IslandSystem& s, double dt) {
  constexpr double unheard_m_per_s = 1e-9;
  double loudest = 0;
  const auto mismatch = [&](int block, const Matrix26& shape) -> Eigen::Vector2d {
    if (block < 0) return Eigen::Vector2d::Zero();
    return shape * (increment_[at(block)] / dt - rate(at(block), placement_[at(block)], states_[at(block)].velocity));
  };
  std::vector<Interaction> actions;
  for (const int k : s.island.contacts) actions.push_back(formulation_->contact(trial(), k, contacts_[at(k)]));
  for (const int k : s.island.supports) actions.push_back(formulation_->support(trial(), k, supports_[at(k)]));
  std::vector<Eigen::Vector2d> pull(actions.size(), Eigen::Vector2d::Zero());
  for (std::size_t k = 0; k < actions.size(); ++k) {
    const Interaction& a = actions[k];
    if (!a.acts()) continue;
    const Eigen::Vector2d m = mismatch(a.block_i, a.shape_i) - mismatch(a.block_j, a.shape_j);
    for (int axis = 0; axis < 2; ++axis) {
      pull[k][axis] = a.held[axis] * m[axis];
      if (a.held[axis] > 0) loudest = std::max(loudest, std::abs(m[axis]));
    }
  }
  if (loudest <= unheard_m_per_s) return;

  set_block_matrices(s);
  s.residual.setZero();
  const auto add = [&](int block, const Vector6& push) {
    if (block < 0 || frozen_[at(block)]) return;
    s.unknowns->add(local_[at(block)], push, s.residual);
  };
  for (std::size_t k = 0; k < actions.size(); ++k) {
    Interaction& a = actions[k];
    if (!a.acts()) continue;
    a.stiffness = a.held.asDiagonal().toDenseMatrix();
    add_stiffness(*s.system, a);
    add(a.block_i, a.shape_i.transpose() * pull[k]);
    if (a.block_j >= 0) add(a.block_j, -(a.shape_j.transpose() * pull[k]));
  }
  if (!s.system->solve(/*symmetric=*/true, s.residual, s.correction)) return;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    states_[at(s.island.blocks[k])].velocity += s.unknowns->take_own(static_cast<int>(k), s.correction);
  }
}

/// Matrix and residual at the trial; returns the largest unbalanced force, less what round-off explains.
double Solid::assemble(IslandSystem& s, bool& symmetric) {
  const Stopwatch watch(profile_.assembly);
  const double mass_factor = newmark_.mass_factor(matrices_dt_);
  set_block_matrices(s);
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
    if (action.constraint_count > 0) return add_constraints(s, action, support, index);
    symmetric = symmetric && action.stiffness(1, 0) == action.stiffness(0, 1);
    add_stiffness(*s.system, action);
  };
  for (const int k : s.island.contacts) add(formulation_->contact(trial(), k, contacts_[at(k)]), false, k);
  for (const int k : s.island.supports) add(formulation_->support(trial(), k, supports_[at(k)]), true, k);
  std::vector<Interaction> bolts;
  for (const int k : s.bolts) bolts.push_back(interaction_of(trial(), bolts_[at(k)], base_.displacement(end_s_)));
  for (const Interaction& bolt : bolts) add(bolt, false, -1);
  if (!s.unknown_forces.empty()) {
    add_own(s.saddle, s);
    for (const Interaction& bolt : bolts) add_stiffness(s.saddle, bolt);
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
    const Vector6 inertia = mass_factor * (blocks_[b].mass * increment_[b]);
    const Vector6 residual = balance_[b] - inertia + history_[b];
    s.unknowns->add(static_cast<int>(k), residual, s.residual);
    const double noise =
        round_off_[b] + round_off * (magnitude(inertia, blocks_[b]) + magnitude(history_[b], blocks_[b]));
    const double force = magnitude(residual, blocks_[b]);
    unbalanced = std::isfinite(force) ? std::max(unbalanced, force - noise) : force;
    if (!std::isfinite(unbalanced)) return unbalanced;
  }
  return std::max(unbalanced, unbalanced_at_nodes(s));
}

}  // namespace blockweir::solid
