// SPDX-License-Identifier: GPL-3.0-or-later
// Many rigid blocks stand as long as any forces in their joints hold them (NUMERICS.md, "Many rigid blocks at rest").
// Strain finds others, and may let go.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_level.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid {

/// Whether the scene has so many rigid blocks, without anchors, and equilibrium does not determine the forces.
bool stands_by_any_forces(const limit::LimitAnalysis& structure);

/// Of a structure that does: adds "with_straining_blocks" {"factor", "text"} and a warning with that text if the same
/// blocks with strain fail with more strength than that of `found` (other_orders.hpp). Of more than 100 blocks, of
/// which an analysis takes minutes, it only warns.
void add_strain_that_lets_go(const limit::LimitAnalysis& structure, Situation& now, const StaticStrength& found,
                             std::optional<double> jumps_below, nlohmann::json& answer);

/// The same beside a level: a warning if blocks with strain do not stand at 0.95 of the rise to it.
void add_strain_that_lets_go(const limit::LimitAnalysis& structure, StillWater& water, const StaticLevel& found,
                             nlohmann::json& answer);

}  // namespace blockweir::solid
