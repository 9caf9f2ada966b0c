// SPDX-License-Identifier: GPL-3.0-or-later
// Which motions of blocks the water of a scene answers.
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Bending of meshes and strains too, where water is a reservoir. With sound, pressures depend on what faces did
/// before: of faces that bend, their part that comes a window late grows.
inline bool answers_bending(const Scene& scene) {
  return scene.fluid == FluidModel::reservoir && scene.analysis.kind == AnalysisKind::dynamic &&
         !scene.reservoir.compressible;
}

}  // namespace blockweir::scene
