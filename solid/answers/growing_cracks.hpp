// SPDX-License-Identifier: GPL-3.0-or-later
// How near to its end a structure is whose cracks let in the water: pressures that grow open the cracks farther, and
// longer cracks let in more. Limit analysis keeps them as long as they are.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/capacity/situation.hpp"

namespace blockweir::solid {

/// Where joints have `uplift = "cracked"`: marks "water_factor" with "keeps_cracks", and warns if the blocks do not
/// stand with water that is heavier by a tenth, whose cracks are found anew.
void add_growing_cracks(const Situation& now, const process::FluidMaker& make_fluid, nlohmann::json& answer);

}  // namespace blockweir::solid
