// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/step/lagging_friction.hpp"
#include "solid/step/newton.hpp"
#include "solid/step/pivoting.hpp"
#include "solid/step/swept_equilibrium.hpp"

namespace blockweir::solid {

bool may_sweep(const StepWorkspace& step, const StepMode& mode) {
  return (mode.sweeps || mode.in_motion()) && !mode.smooth_only && !mode.friction_lags &&
         step.formulation->force_constraints() == nullptr;
}

namespace {

/// Do rigid blocks move in the step that rested before it? Many: few move as the forces before have it.
bool begins_to_move(const StepWorkspace& step, const IslandEquations& island) {
  constexpr double moving = 1e-6;   // of a fall through the step
  constexpr double resting = 1e-3;  // what sweeps leave is less
  const auto& blocks = island.island.blocks;
  const bool rigid = island.unknowns->total == 3 * island.unknowns->blocks();
  const auto farther = [&](const Vector6& way, int block, double share) {
    return way.head<2>().norm() + step.model.blocks[at(block)].radius * std::abs(way[2]) > share * step.trial.fall_m();
  };
  return rigid && island.unknowns->total > few_unknowns &&
         std::any_of(blocks.begin(), blocks.end(),
                     [&](int b) { return farther(step.trial.increment[at(b)], b, moving); }) &&
         std::none_of(blocks.begin(), blocks.end(),
                      [&](int b) { return farther(step.trial.dt * step.state.blocks[at(b)].velocity, b, resting); });
}

/// As the step began it, for Newton's method.
void begin_anew(StepWorkspace& step, IslandEquations& island) {
  const IslandContacts contacts = island.island_contacts();
  step.formulation->undo(contacts);
  for (const int b : island.island.blocks) step.trial.predict(at(b));
  step.formulation->begin(step.trial.at_start(), step.trial.matrix, step.trial.frozen, contacts);
  if (island.unknowns->total > large_island) step.formulation->keep_forces(step.trial.at_start(), contacts);
}

}  // namespace

Found find_equilibrium(StepWorkspace& step, IslandEquations& island, const StepMode& mode, bool newton) {
  if (newton && find_by_newton(step, island, mode)) {
    if (!mode.in_motion() || !may_sweep(step, mode) || !begins_to_move(step, island)) return Found::by_newton;
    // Coulomb's law leaves more than one solution: what rests goes on resting if it can.
    SweptEquilibrium swept(step);
    if (swept.may_rest(island)) return swept.find(island, mode);
    begin_anew(step, island);
    return find_by_newton(step, island, mode) ? Found::by_newton : swept.find(island, mode);
  }
  if (newton && mode.pivots && Pivoting(step).find(island, mode)) return Found::by_newton;
  return may_sweep(step, mode) ? SweptEquilibrium(step).find(island, mode) : Found::nothing;
}

bool find_by_newton(StepWorkspace& step, IslandEquations& island, const StepMode& mode) {
  return mode.friction_lags ? LaggingFriction(step).find(island, mode) : Newton(step).find(island, mode);
}

}  // namespace blockweir::solid
