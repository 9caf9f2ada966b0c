// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/step/centred_forces.hpp"
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

/// Velocities of a large island are round-off if they would displace it by no more: with penalties times that, a
/// standing wall would be out of balance at the start of each step.
void start_where_it_rests(StepWorkspace& step, const IslandEquations& s) {
  const double round_off_m = 10 * step.formulation->settings().position_round_off_m;
  if (s.unknowns->total <= large_island || s.unknowns->shared()) return;
  for (const int block : s.island.blocks) {
    const auto b = at(block);
    const Vector6& increment = step.trial.increment[b];
    const double moved = increment.head<2>().norm() + step.model.blocks[b].radius * increment.tail<4>().norm();
    if (moved <= round_off_m) step.trial.go_to(b, Vector6::Zero());
  }
}

/// As the step began it, for Newton's method.
void begin_anew(StepWorkspace& step, IslandEquations& island) {
  const IslandContacts contacts = island.island_contacts();
  step.formulation->undo(contacts);
  for (const int b : island.island.blocks) step.trial.predict(at(b));
  start_where_it_rests(step, island);
  step.formulation->begin(step.trial.at_start(), step.trial.matrix, step.trial.frozen, contacts);
  if (island.unknowns->total > large_island) step.formulation->keep_forces(step.trial.at_start(), contacts);
}

}  // namespace

Found find_equilibrium(StepWorkspace& step, IslandEquations& island, const StepMode& mode, bool newton) {
  start_where_it_rests(step, island);
  Held held = Held::unknown;
  CentredForces centred(step);
  if (centred.may_hold(island, mode)) {
    held = centred.hold(island);
    step.held = step.held || held == Held::yes;
    if (held == Held::yes) return Found::by_newton;
    step.must_move = step.must_move || held == Held::no;
    begin_anew(step, island);
  }
  if (mode.stays) return Found::nothing;
  // Once Newton's method has not found how many rigid blocks move, it does not: of 851 further attempts none did.
  if (centred.suits(island, mode) && may_sweep(step, mode) && step.state.whole_law.after_failure()) newton = false;
  if (newton && find_by_newton(step, island, mode)) return Found::by_newton;
  if (newton && mode.pivots && Pivoting(step).find(island, mode)) return Found::by_newton;
  return may_sweep(step, mode) ? SweptEquilibrium(step, held).find(island, mode) : Found::nothing;
}

bool find_by_newton(StepWorkspace& step, IslandEquations& island, const StepMode& mode) {
  return mode.friction_lags ? LaggingFriction(step).find(island, mode) : Newton(step).find(island, mode);
}

}  // namespace blockweir::solid
