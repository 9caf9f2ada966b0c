// SPDX-License-Identifier: GPL-3.0-or-later
// What a factor on strength does not show: closeness to overturning, anchors that are activated only by motion, bonds
// that hold although the joint is in tension or break one after the other, and what strain alone holds.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/limit/limit_strength.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

constexpr double scarce_water_factor = 1.1;  ///< a factor on the water below it is warned of

/// Adds "water_factor" {"factor", "gap"}: the factor by which the water pressure, uplift included, may grow, by limit
/// analysis; null: nothing of it is borne. Where anchors at their prestress lower it by more than 1 %, "factor" is the
/// lower, and "with_anchors_at_yield" the other (null: any). Warns of what stands with a factor below 1.1.
void add_water_factor(const limit::LimitAnalysis& structure, Situation& now, const limit::Wrenches& stated,
                      const limit::LimitStrength& strength, nlohmann::json& answer);

/// Anchors stretch as blocks move, and motion up to [analysis] failure_displacement_m is not failure. Warns if the
/// factor differs when a tenth of that motion is allowed.
void add_stretch_of_anchors(Situation& now, const StaticStrength& found, nlohmann::json& answer);

/// Strain presses blocks against each other, by Poisson's ratio and by settling, and where equilibrium does not
/// determine friction that may hold a structure that falls otherwise. Adds "with_rigid_blocks" {"factor", "text"} and a
/// warning with that text if the same blocks without strain fail with more strength (other_orders.hpp).
void add_rigid_blocks(const limit::LimitAnalysis& structure, Situation& now, const StaticStrength& found,
                      std::optional<double> jumps_below, nlohmann::json& answer);

/// Where joints close loops and slip destroys their bonds, the one that breaks first decides.
/// Adds "without_bonds" {"factor", "text"}, by limit analysis with residual friction alone, and a warning with that
/// text if the blocks' factor is larger by a twentieth.
void add_brittle_bonds(const limit::LimitAnalysis& structure, Situation& now, const StaticStrength& found,
                       const limit::Wrenches& loads, nlohmann::json& answer);

/// Warns of joints in tension that their bond holds. If their cohesion counts, adds "with_cracked_joint": the factor by
/// limit analysis with cohesion on the compressed part of such joints only.
void add_cracked_joints(const Solid& blocks, Situation& now, nlohmann::json& answer);

}  // namespace blockweir::solid
