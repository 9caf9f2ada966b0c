// SPDX-License-Identifier: GPL-3.0-or-later
// The forces on the joints in a safety answer.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_strength.hpp"

namespace blockweir::solid {

/// Joint forces of the structure as stated; if it fails, with the strength at which it would just stand.
void add_joints(Situation& now, const process::FluidMaker& make_fluid, const StaticStrength& found,
                nlohmann::json& answer);

}  // namespace blockweir::solid
