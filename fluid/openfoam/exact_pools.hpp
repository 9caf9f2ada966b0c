// SPDX-License-Identifier: GPL-3.0-or-later
// The pools at time 0 as the blocks' exact shapes bound them, whatever the mesh.
#pragma once

#include "fluid/hydrostatic/wet_faces.hpp"
#include "fluid/openfoam/grid.hpp"

namespace blockweir::openfoam {

struct PoolLevels {
  double upstream_m = 0;  ///< minus infinity: no such pool
  double downstream_m = 0;
};
PoolLevels levels_at_start(const scene::Scene& scene);

struct ExactPool {
  hydrostatic::Pool pool;
  double level_m;
  hydrostatic::WetFaces faces;
  /// Depth under the level [m]; 0 above it.
  [[nodiscard]] double depth(const scene::Point& p) const;
  [[nodiscard]] bool holds(const scene::Point& p) const;
};

/// Of the blocks' `outlines` in the grid.
std::vector<ExactPool> exact_pools(const scene::Scene& scene, const Grid& grid,
                                   std::vector<std::vector<scene::Point>> outlines);

/// Whether an odd number of the rings holds the point.
bool within(const std::vector<std::vector<scene::Point>>& rings, const scene::Point& p);

}  // namespace blockweir::openfoam
