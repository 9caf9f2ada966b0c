// SPDX-License-Identifier: GPL-3.0-or-later
// What a reservoir does beside its pressure at rest: ice, the added pressure of an earthquake, and water on a crest
// that is overtopped. All follow the level.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/hydrostatic/pools.hpp"

namespace blockweir::hydrostatic {

/// Adds to `load`, behind what is there, on blocks where `outlines` are; the crest first, then ice, then earthquake:
/// ice: its thrust as a uniform pressure on upstream faces, from the level down by its thickness;
/// earthquake: Westergaard's 7/8 k_h rho g sqrt(H z) |n_x| on upstream faces, H the depth over the lowest wet point of
/// what can move, z that under the level, n_x the horizontal part of the normal; as much less, with the tailwater's own
/// depth, on faces that look downstream into it;
/// crest: the head over the structure's highest level edges, falling to zero at their downstream end or not, where no
/// body of water wets them. The reservoir is the first of the bodies.
void add_reservoir_loads(const scene::Scene& scene, const std::vector<std::vector<Point>>& outlines,
                         const std::vector<WaterBody>& bodies, wire::Load& load);

}  // namespace blockweir::hydrostatic
