// SPDX-License-Identifier: GPL-3.0-or-later
// The pools at time 0, bounded by the exact shapes of the blocks instead of the mesh.
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
  /// Depth below the level [m]; 0 above it.
  [[nodiscard]] double depth(const scene::Point& p) const;
  [[nodiscard]] bool holds(const scene::Point& p) const;
};

/// Pools between the blocks' `outlines` within the grid.
std::vector<ExactPool> exact_pools(const scene::Scene& scene, const Grid& grid,
                                   std::vector<std::vector<scene::Point>> outlines);

/// Whether an odd number of the rings contain the point.
bool within(const std::vector<std::vector<scene::Point>>& rings, const scene::Point& p);

}  // namespace blockweir::openfoam
