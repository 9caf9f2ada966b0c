// SPDX-License-Identifier: GPL-3.0-or-later
// What can come in at the mesh's ends, and what cannot.
#pragma once

#include "bridge/scene/scene.hpp"
#include "fluid/openfoam/grid.hpp"
#include "fluid/openfoam/stokes_wave.hpp"

namespace blockweir::openfoam {

/// The scene's regular waves, in the depth of the pool over its ground.
StokesWave stokes_wave(const scene::Scene& scene, const Grid& grid);

/// Throws std::invalid_argument where a pool that is to rise has no water yet, and where waves are beyond Stokes's
/// second order.
void check_inflow(const scene::Scene& scene, const Grid& grid);

}  // namespace blockweir::openfoam
