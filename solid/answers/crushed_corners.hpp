// SPDX-License-Identifier: GPL-3.0-or-later
// What hangs on a corner of a block that stands in a kink of another one, as the toe of a dam at the foot of a rising
// plane: in a scene it bears any force on no length, in nature it is crushed, and the block slides on its face alone.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/limit/limit_level.hpp"
#include "solid/limit/limit_strength.hpp"

namespace blockweir::solid {

/// Both add "with_crushed_corners" {"factor" or "level_m", "text"} and a warning with that text, where the answer
/// without such corners is lower by more than 1e-3.
void add_strength_with_crushed_corners(const limit::LimitAnalysis& structure, const limit::Wrenches& loads,
                                       const limit::LimitStrength& found, nlohmann::json& answer);
void add_level_with_crushed_corners(const limit::LimitAnalysis& structure, const limit::Wrenches& dead,
                                    const limit::WaterAtLevel& water, const limit::LevelRange& range,
                                    const limit::LimitLevel& found, nlohmann::json& answer);

}  // namespace blockweir::solid
