// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cells that the pools' water fills at time 0.
#pragma once

#include "fluid/openfoam/exact_pools.hpp"

namespace blockweir::openfoam {

/// Share of each cell that blocks fill.
std::vector<double> filled_cells(const Grid& grid, const std::vector<std::vector<scene::Point>>& outlines);

enum class Holds : char { unknown, air, upstream, downstream };

/// Content of every cell. Water spreads from the two ends of the mesh through cells free of blocks, up to the crest,
/// above which the structure still separates the pools. Other cells contain the pool that reaches into them by `pools`;
/// cells inside blocks have the content beside them.
std::vector<Holds> pool_cells(const Grid& grid, const scene::Scene& scene, const std::vector<double>& filled,
                              const std::vector<ExactPool>& pools);

}  // namespace blockweir::openfoam
