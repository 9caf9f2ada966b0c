// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions of the linearized equations, by the matrix that belongs to the residual.
#include <algorithm>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/solve/condition_number.hpp"
#include "solid/step/island_equations.hpp"
#include "solid/step/island_matrix.hpp"

namespace blockweir::solid {

void IslandEquations::set_block_matrices() {
  system().set_zero();
  IslandMatrix(model_, trial_, *this).add_own(system());
  system().set_beside(water_.beside(*this));
}

void IslandEquations::add_stiffness(const Interaction& action) {
  IslandMatrix(model_, trial_, *this).add_stiffness(system(), action);
}

/// The matrix that belongs to the residual. Where there are many, each block takes up its own columns, in the same
/// order, unless blocks share them.
void IslandEquations::assemble() {
  const Stopwatch watch(profile_.assembly);
  set_block_matrices();
  if (unknowns->shared() || island.blocks.size() < many) {
    for (const Interaction& action : actions) add_stiffness(action);
    return;
  }
  const IslandMatrix matrix(model_, trial_, *this);
  for_each(island.blocks.size(), [&](std::size_t k) {
    for (const Incidence::End& end : incidence.of(k)) {
      matrix.add_columns(system(), actions[at(end.interaction)], end.second);
    }
  });
}

bool IslandEquations::solve_linearized() {
  if (!forces_.any()) assemble();
  const Stopwatch watch(profile_.solve);
  if (!forces_.any()) {
    const SolutionTimes before = system().times();
    if (!solve(symmetric_)) return false;
    profile_.factorization += system().times().factorization - before.factorization;
    profile_.refinement += system().times().refinement - before.refinement;
    ++(system().reused() ? counts_.reused_factorizations : counts_.factorizations);
  } else {
    if (!forces_.solve(*this)) return false;
  }
  ++counts_.iterations;
  step_.go_on();
  if (model_.scene.contact.measure_condition) {
    counts_.condition_number =
        std::max(counts_.condition_number, condition_number(forces_.any() ? forces_.dense() : system().dense()));
  }
  return true;
}

bool IslandEquations::solve_symmetric() {
  symmetric_ = true;
  return solve_linearized();
}

bool IslandEquations::solve(bool symmetric) {
  if (!model_.scene.analysis.reuse_factors) system().forget_factors();
  if (!system().solve(symmetric, residual, correction)) return false;
  return correction.allFinite();
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

}  // namespace blockweir::solid
