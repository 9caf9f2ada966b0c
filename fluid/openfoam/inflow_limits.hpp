// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the inflow at the ends of the mesh.
#pragma once

#include "bridge/scene/scene.hpp"
#include "fluid/openfoam/grid.hpp"
#include "fluid/openfoam/stokes_wave.hpp"

namespace blockweir::openfoam {

/// The scene's regular waves, for the depth of the pool above its ground.
StokesWave stokes_wave(const scene::Scene& scene, const Grid& grid);

/// Throws std::invalid_argument if a pool that shall rise has no water yet, or if waves exceed the range of Stokes's
/// second order.
void check_inflow(const scene::Scene& scene, const Grid& grid);

}  // namespace blockweir::openfoam
