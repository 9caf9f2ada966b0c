// SPDX-License-Identifier: GPL-3.0-or-later
// Which cells of the mesh the pools' water reaches at time 0.
#pragma once

#include "fluid/openfoam/exact_pools.hpp"

namespace blockweir::openfoam {

/// Share of each cell that blocks fill.
std::vector<double> filled_cells(const Grid& grid, const std::vector<std::vector<scene::Point>>& outlines);

enum class Holds : char { unknown, air, upstream, downstream };

/// What every cell holds. Water spreads from the mesh's two ends through cells that no block reaches, below the crest,
/// above which the structure holds it back, too. Other cells hold the pool that reaches into them by `pools`, those
/// inside blocks what is beside them.
std::vector<Holds> pool_cells(const Grid& grid, const scene::Scene& scene, const std::vector<double>& filled,
                              const std::vector<ExactPool>& pools);

}  // namespace blockweir::openfoam
