// SPDX-License-Identifier: GPL-3.0-or-later
// Hydrostatic initial water in both pools, exact in every cell, so that OpenFOAM starts without a jolt.
#pragma once

#include "fluid/openfoam/grid.hpp"

namespace blockweir::openfoam {

/// One value for each cell, rows from the bottom up, each from left to right.
struct InitialWater {
  double reference_level_m = 0;          ///< interFoam's hRef
  std::vector<double> fraction;          ///< of water
  std::vector<double> p_rgh_pa;          ///< pressure less rho g (hRef - y)
  std::vector<scene::Point> velocity{};  ///< m/s; empty if all is at rest
};

/// Levels of time 0. A pool is the region below its level connected to the mesh's left or right end; cells within
/// blocks take the fraction of the nearest cell outside.
InitialWater initial_water(const Grid& grid, const scene::Scene& scene);

}  // namespace blockweir::openfoam
