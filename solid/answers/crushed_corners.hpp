// SPDX-License-Identifier: GPL-3.0-or-later
// The effect of corners wedged in a kink of another block, such as the toe of a dam at the foot of a rising plane. In
// the model such a corner carries any force on zero length; in nature it is crushed, and the block slides on its face.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/limit/limit_level.hpp"
#include "solid/limit/limit_strength.hpp"

namespace blockweir::solid {

/// Both add "with_crushed_corners" {"factor" or "level_m", "text"} and a warning with that text, if the result without
/// such corners is lower by more than 1e-3.
void add_strength_with_crushed_corners(const limit::LimitAnalysis& structure, const limit::Wrenches& loads,
                                       const limit::LimitStrength& found, nlohmann::json& answer);
void add_level_with_crushed_corners(const limit::LimitAnalysis& structure, const limit::Wrenches& dead,
                                    const limit::WaterAtLevel& water, const limit::LevelRange& range,
                                    const limit::LimitLevel& found, nlohmann::json& answer);

}  // namespace blockweir::solid
