// SPDX-License-Identifier: GPL-3.0-or-later
// Where equilibrium does not determine friction, even the order in which blocks are listed may decide which forces they
// find, and so whether they stand. Their factor in four other orders, without strain: from left to right and from right
// to left, those above each other upwards and downwards.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "bridge/process/sides.hpp"
#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid {

/// The factor of other blocks under the same loads if they fail with more than the strength of `found`: with 1 / 0.95
/// (friction that is not determined jumps by less from one analysis to the next), 1 / 0.7 or twice of it. Otherwise
/// bears_any.
StaticStrength strength_if_lower(const scene::Scene& other, Situation& now, const StaticStrength& found,
                                 std::optional<double> jumps_below);

/// Adds "with_blocks_reordered" {"factor", "text"} and a warning with that text if their factor is lower by a
/// twentieth. "factor" is 0 if no strength holds them.
void add_strength_in_other_orders(const limit::LimitAnalysis& structure, const process::FluidMaker& make_fluid,
                                  const StaticStrength& found, std::optional<double> jumps_below,
                                  nlohmann::json& answer);

}  // namespace blockweir::solid
