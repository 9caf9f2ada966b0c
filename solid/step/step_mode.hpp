// SPDX-License-Identifier: GPL-3.0-or-later
// How a step is tried, and what comes of it.
#pragma once

#include <vector>

#include "solid/block/panel.hpp"
#include "solid/step/newmark.hpp"

namespace blockweir::solid {

/// The step to be made, and the water that presses as it ends.
struct Stretch {
  double dt = 0;     ///< s
  double end_s = 0;  ///< s
  const std::vector<Panel>& water;
};

struct StepMode {
  Newmark scheme{};
  bool settles = false;        ///< the state of time 0 is looked for: no work counts, nothing sleeps
  bool smooth_only = false;    ///< the step is not to be where contacts change
  bool friction_lags = false;  ///< bounds of shear follow the normal forces from behind
  bool pivots = false;         ///< where states of small islands at rest run in circles
  bool sweeps = false;         ///< where all else has failed on the way to rest
  bool roughly = false;        ///< sweeps count wherever they end

  /// Of states that only pass, not looked for as states of rest.
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

/// Of an island in a step.
enum class Found {
  nothing,
  asleep,     ///< what it had
  corners,    ///< that were let pass have gone into a block: contacts are lacking
  by_newton,  ///< states in equilibrium, to round-off
  finished,   ///< the same, from where sweeps had come near
  by_sweeps   ///< to within the time integrator's error
};

/// Of a try to make a step. All but a step that is made leave the state as it was.
enum class Outcome {
  made,
  not_found,       ///< no states of contacts in equilibrium
  too_far,         ///< states were found, but blocks move or turn by more than a step may
  contacts_change  ///< so they do, in a step that was to be smooth
};

}  // namespace blockweir::solid
