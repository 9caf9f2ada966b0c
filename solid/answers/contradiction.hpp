// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks' own search and limit analysis, an upper bound, where they cannot both be right of the scene as drawn.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/capacity/static_strength.hpp"
#include "solid/limit/limit_strength.hpp"

namespace blockweir::solid {

/// Whatever the strength, one of the two has the structure stand and the other has it fail.
bool contradict(const StaticStrength& blocks, const limit::LimitStrength& bound);

/// Takes the factor out of such an answer and says why. The outcome is "not found", unless both fail as the scene
/// stands. Adds "contradiction".
void add_contradiction(const StaticStrength& blocks, const limit::LimitStrength& bound, nlohmann::json& answer);

}  // namespace blockweir::solid
