// SPDX-License-Identifier: GPL-3.0-or-later
// Which motions of blocks cause water pressure.
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Do bending and strain cause pressure, beside rigid motion? In a reservoir of incompressible water they do. With
/// sound the pressures depend on the past, and on bending faces the part that comes a window late would grow.
inline bool answers_bending(const Scene& scene) {
  return scene.fluid == FluidModel::reservoir && scene.analysis.kind == AnalysisKind::dynamic &&
         !scene.reservoir.compressible;
}

}  // namespace blockweir::scene
