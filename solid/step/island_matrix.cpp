// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix that belongs to the residual, and solutions of the linearized equations.
#include <algorithm>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/solve/condition_number.hpp"
#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

/// The blocks' own matrices on the diagonal, and what triangles of a mesh share beside it.
template <class System>
void IslandEquations::add_own(System& to) const {
  for (const int b : island.blocks) to.add(local(b), local(b), trial_.matrix[at(b)]);
  for (const int k : couplings) {
    const StrainCoupling& c = model_.parts.couplings[at(k)];
    Matrix6 shared = Matrix6::Zero();
    shared.bottomRightCorner<3, 3>() =
        (1 + trial_.scheme.velocity_factor(trial_.dt) * trial_.retardation_s(at(c.i))) * c.stiffness;
    to.add(local(c.i), local(c.j), shared);
    to.add(local(c.j), local(c.i), shared);
  }
}

void IslandEquations::set_block_matrices() {
  system().set_zero();
  add_own(system());
}

/// What a contact or support adds to the matrix: J^T C J on the diagonal of each block, -J^T C J between the two.
template <class System>
void IslandEquations::add_stiffness_to(System& to, const Interaction& action) const {
  add_columns(to, action, false);
  add_columns(to, action, true);
}

void IslandEquations::add_stiffness(const Interaction& action) {
  add_stiffness_to(system(), action);
}

/// In the columns of one of both blocks.
template <class System>
void IslandEquations::add_columns(System& to, const Interaction& action, bool of_second) const {
  const int column = action.block(of_second);
  if (!trial_.moves(column) || action.stiffness.isZero(0)) return;
  const Matrix26 shape = action.shape(trial_.placement[at(column)], of_second);
  const Matrix26 force = action.stiffness * shape;
  to.add(local(column), local(column), shape.transpose() * force);
  const int row = action.block(!of_second);
  if (!trial_.moves(row)) return;
  to.add(local(row), local(column), -action.shape(trial_.placement[at(row)], !of_second).transpose() * force);
}

/// The matrix that belongs to the residual. Each block takes up its own columns, but where blocks share them.
void IslandEquations::assemble() {
  const Stopwatch watch(profile_.assembly);
  set_block_matrices();
  if (unknowns->shared()) {
    for (const Interaction& action : actions) add_stiffness(action);
    return;
  }
  for_each(island.blocks.size(), [&](std::size_t k) {
    for (const Incidence::End& end : incidence.of(k)) {
      add_columns(system(), actions[at(end.interaction)], end.second);
    }
  });
}

/// Where forces are unknowns.
void IslandEquations::set_saddle() {
  const std::vector<int>& contacts = island.contacts;
  const std::vector<int>& supports = island.supports;
  const std::size_t of_bolts = contacts.size() + supports.size();
  unknown_forces_.clear();
  if (!formulation_->solves_for_forces()) return;
  saddle_.set_zero();
  for (std::size_t k = 0; k < of_bolts; ++k) {
    const bool support = k >= contacts.size();
    add_constraints(actions[k], support, support ? supports[k - contacts.size()] : contacts[k]);
  }
  if (unknown_forces_.empty()) return;
  add_own(saddle_);
  for (std::size_t i = 0; i < bolts.size(); ++i) add_stiffness_to(saddle_, actions[of_bolts + i]);
  water_.add_to_saddle(*this, saddle_);
}

/// Forces that are unknowns: their columns and equations.
void IslandEquations::add_constraints(const Interaction& action, bool support, int index) {
  for (const Constraint& c :
       support ? formulation_->constraints_of_support(index) : formulation_->constraints_of_contact(index)) {
    saddle_.add_force(c.violation, c.compliance);
    unknown_forces_.push_back({support, index, c.force});
    for (const bool second : {false, true}) {
      const int block = action.block(second);
      if (!trial_.moves(block)) continue;
      const Matrix26 shape = (second ? -1 : 1) * action.shape(trial_.placement[at(block)], second);
      saddle_.couple(local(block), shape.transpose() * c.force, shape.transpose() * c.row);
    }
  }
}

bool IslandEquations::solve_linearized() {
  if (unknown_forces_.empty()) assemble();
  const Stopwatch watch(profile_.solve);
  if (unknown_forces_.empty()) {
    const SolutionTimes before = system().times();
    if (!solve(symmetric_)) return false;
    profile_.factorization += system().times().factorization - before.factorization;
    profile_.refinement += system().times().refinement - before.refinement;
    ++(system().reused() ? counts_.reused_factorizations : counts_.factorizations);
  } else {
    if (!saddle_.solve(residual, correction, forces_)) return false;
    correct_forces();
  }
  ++counts_.iterations;
  if (step_.meanwhile) step_.meanwhile();
  if (model_.scene.contact.measure_condition) {
    counts_.condition_number = std::max(counts_.condition_number,
                                        condition_number(unknown_forces_.empty() ? system().dense() : saddle_.dense()));
  }
  return true;
}

bool IslandEquations::solve(bool symmetric) {
  if (!model_.scene.analysis.reuse_factors) system().forget_factors();
  if (!system().solve(symmetric, residual, correction)) return false;
  water_factors_ = water_.factors(*this);
  WaterInertia::correct(water_factors_, correction);
  return correction.allFinite();
}

Eigen::VectorXd IslandEquations::solve_again(const Eigen::VectorXd& force) const {
  Eigen::VectorXd d = system().solve_again(force);
  WaterInertia::correct(water_factors_, d);
  return d;
}

void IslandEquations::move(double fraction) {
  for (const auto& [node, first] : unknowns->nodes) {
    trial_.node_increment[at(node)] += fraction * correction.segment<2>(first);
  }
  for_each(island.blocks.size(), [&](std::size_t k) {
    const auto b = at(island.blocks[k]);
    if (model_.blocks[b].is_part()) return trial_.follow_corners(b);
    trial_.go_to(b, trial_.increment[b] + fraction * unknowns->take(static_cast<int>(k), correction));
  });
}

void IslandEquations::correct_forces() {
  std::size_t next = 0;  // of the unknown forces; those of a contact or support follow each other
  const auto force_of = [&](bool support, int index) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (; next < unknown_forces_.size(); ++next) {
      const UnknownForce& unknown = unknown_forces_[next];
      if (unknown.support != support || unknown.index != index) break;
      sum += forces_[static_cast<Eigen::Index>(next)] * unknown.force;
    }
    return sum;
  };
  for (const int k : island.contacts) formulation_->correct_contact(k, state_.contacts[at(k)], force_of(false, k));
  for (const int k : island.supports) formulation_->correct_support(k, state_.supports[at(k)], force_of(true, k));
}

}  // namespace blockweir::solid
