// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/equilibrium.hpp"

#include "solid/step/lagging_friction.hpp"
#include "solid/step/newton.hpp"
#include "solid/step/pivoting.hpp"
#include "solid/step/swept_equilibrium.hpp"

namespace blockweir::solid {

bool may_sweep(const StepWorkspace& step, const StepMode& mode) {
  return (mode.sweeps || mode.in_motion()) && !mode.smooth_only && !mode.friction_lags &&
         step.formulation->force_constraints() == nullptr;
}

Found find_equilibrium(StepWorkspace& step, IslandEquations& island, const StepMode& mode, bool newton) {
  if (newton && find_by_newton(step, island, mode)) return Found::by_newton;
  if (newton && mode.pivots && Pivoting(step).find(island, mode)) return Found::by_newton;
  return may_sweep(step, mode) ? SweptEquilibrium(step).find(island, mode) : Found::nothing;
}

bool find_by_newton(StepWorkspace& step, IslandEquations& island, const StepMode& mode) {
  return mode.friction_lags ? LaggingFriction(step).find(island, mode) : Newton(step).find(island, mode);
}

}  // namespace blockweir::solid
