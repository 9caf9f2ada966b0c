// SPDX-License-Identifier: GPL-3.0-or-later
// Detects where block analysis and limit analysis (an upper bound) cannot both be right for the scene as drawn.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/capacity/static_strength.hpp"
#include "solid/limit/limit_strength.hpp"

namespace blockweir::solid {

/// Whether, at any strength, one of the two methods finds the structure stable and the other finds it failing.
bool contradict(const StaticStrength& blocks, const limit::LimitStrength& bound);

/// Removes the factor from such an answer and adds "contradiction" with the reason. The outcome is "not found", unless
/// both methods find that the structure fails with its stated strength.
void add_contradiction(const StaticStrength& blocks, const limit::LimitStrength& bound, nlohmann::json& answer);

}  // namespace blockweir::solid
