// SPDX-License-Identifier: GPL-3.0-or-later
// Which motions of blocks cause water pressure.
#pragma once

#include "bridge/scene/newmark_weights.hpp"

namespace blockweir::scene {

/// Does water with sound compute its pressures a window ahead? Blocks and water then make each window as one step of
/// the integrator (fluid/reservoir/window_ahead.hpp). The parallel schedule does not know enough for that, and in
/// several steps a window the blocks would feel another added mass than the water has: the reader refuses both.
inline bool answers_ahead(const Scene& scene) {
  constexpr double round_off = 1e-9;
  return scene.fluid == FluidModel::reservoir && scene.analysis.kind == AnalysisKind::dynamic &&
         scene.reservoir.compressible && scene.coupling.schedule != Schedule::parallel &&
         scene.coupling.added_mass_guard && scene.analysis.step_s >= scene.coupling.window_s * (1 - round_off);
}

/// Do bending and strain cause pressure, beside rigid motion? In a reservoir they do.
inline bool answers_bending(const Scene& scene) {
  return scene.fluid == FluidModel::reservoir && scene.analysis.kind == AnalysisKind::dynamic;
}

/// By how much the velocities told are ahead of the blocks, where the water answers ahead [s]: v + (1 - gamma) T a.
/// Over a window T they change by T times the acceleration at its end.
inline double velocities_ahead_s(const Scene& scene) {
  const Analysis& a = scene.analysis;
  return (1 - newmark_weights(a.integrator, a.spectral_radius).gamma) * scene.coupling.window_s;
}

}  // namespace blockweir::scene
