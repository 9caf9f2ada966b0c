// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of a reservoir besides hydrostatic pressure: ice, added pressure of an earthquake, and water on an overtopped
// crest. All follow the level.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/hydrostatic/pools.hpp"

namespace blockweir::hydrostatic {

/// Appends to `load`, for blocks with these `outlines`, first the crest, then ice, then earthquake.
/// ice: its thrust as a uniform pressure on upstream faces, from the level down by its thickness;
/// earthquake: Westergaard's 7/8 k_h rho g sqrt(H z) |n_x| on upstream faces, H the depth above the lowest wet point of
/// moving blocks, z the depth below the level, n_x the horizontal part of the normal; in the tailwater the same with
/// its own depth, subtracted;
/// crest: the head above the structure's highest horizontal edges, falling to zero at their downstream end or constant,
/// where no body of water wets them. The reservoir is the first of the bodies.
void add_reservoir_loads(const scene::Scene& scene, const std::vector<std::vector<Point>>& outlines,
                         const std::vector<WaterBody>& bodies, wire::Load& load);

}  // namespace blockweir::hydrostatic
