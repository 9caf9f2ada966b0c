// SPDX-License-Identifier: GPL-3.0-or-later
// What a reservoir does beside its pressure at rest, taken apart for sums that are followed by hand: ice, and the added
// pressure of an earthquake.
#pragma once

#include <vector>

#include "bridge/process/sides.hpp"
#include "solid/watch/joint_sums.hpp"

namespace blockweir::solid {

/// Each is the difference that it makes to the forces of open water at this level. Throws as StillWater does.
std::vector<WaterPart> reservoir_parts(const scene::Scene& scene, const process::FluidMaker& make_fluid,
                                       double level_m);

/// As tables call the water's added pressure in the scene's earthquake: by whom it is found.
std::string added_water_name(const scene::Scene& scene);

}  // namespace blockweir::solid
