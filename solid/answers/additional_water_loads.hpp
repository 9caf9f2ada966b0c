// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of a reservoir besides still water, listed separately for a check by hand: ice, and the added pressure of an
// earthquake.
#pragma once

#include <vector>

#include "bridge/process/sides.hpp"
#include "solid/watch/joint_sums.hpp"

namespace blockweir::solid {

/// Each load is the difference it makes to the forces of open water at this level. Throws as StillWater does.
std::vector<WaterPart> additional_water_loads(const scene::Scene& scene, const process::FluidMaker& make_fluid,
                                              double level_m);

/// The name in tables of the added water pressure in the scene's earthquake, after its source.
std::string added_water_name(const scene::Scene& scene);

}  // namespace blockweir::solid
