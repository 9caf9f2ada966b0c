// SPDX-License-Identifier: GPL-3.0-or-later
// How a step is tried, and its outcome.
#pragma once

#include <vector>

#include "solid/block/panel.hpp"
#include "solid/step/newmark.hpp"

namespace blockweir::solid {

/// The interval of a step, and the water pressure at its end.
struct Stretch {
  double dt = 0;     ///< s
  double end_s = 0;  ///< s
  const std::vector<Panel>& water;
};

struct StepMode {
  Newmark scheme{};
  bool settles = false;        ///< initial equilibrium: not counted as work, nothing sleeps
  bool smooth_only = false;    ///< rejects the step if contacts change
  bool friction_lags = false;  ///< bounds of shear follow the normal forces with a delay
  bool pivots = false;         ///< for small islands at rest whose states cycle
  bool sweeps = false;         ///< while settling, if all else has failed
  bool stays = false;          ///< accepts no motion: asks whether forces hold many rigid blocks where they are
  bool roughly = false;        ///< accepts sweeps whatever their error

  /// Transient states, not a search for equilibrium.
  [[nodiscard]] bool in_motion() const { return scheme.damps; }
  [[nodiscard]] StepMode with_lagging_friction() const { return with(&StepMode::friction_lags, true); }
  [[nodiscard]] StepMode by_whole_law() const { return with(&StepMode::friction_lags, false); }
  [[nodiscard]] StepMode with_pivoting() const { return with(&StepMode::pivots, true); }
  [[nodiscard]] StepMode with_sweeps() const { return with(&StepMode::sweeps, true); }
  [[nodiscard]] StepMode with_rough_sweeps() const { return with(&StepMode::roughly, true); }

 private:
  [[nodiscard]] StepMode with(bool StepMode::*what, bool on) const {
    StepMode other = *this;
    other.*what = on;
    return other;
  }
};

/// Result for an island in a step.
enum class Found {
  nothing,
  asleep,                  ///< skipped: keeps its state
  corners,                 ///< corners that were ignored have entered a block: contacts are missing
  by_newton,               ///< equilibrium to round-off
  by_newton_after_sweeps,  ///< by Newton's method after sweeps, to round-off
  by_sweeps                ///< to within the integrator's error
};

/// Result of an attempted step. Unless the step is made, the state is unchanged.
enum class Outcome {
  made,
  not_found,       ///< no contact states in equilibrium
  too_far,         ///< equilibrium found, but blocks move or rotate more than a step may
  contacts_change  ///< contacts change in a step that must be smooth
};

}  // namespace blockweir::solid
