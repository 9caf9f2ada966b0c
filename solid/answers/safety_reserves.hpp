// SPDX-License-Identifier: GPL-3.0-or-later
// What a factor on strength does not show: how near a structure is to turning over, what anchors take up only as it
// moves, and bonds that hold where the joint is in tension.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/limit/limit_strength.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// By which all that the water presses may grow, its uplift included, by limit analysis: "water_factor". Warns where
/// that is by less than a tenth though strength has more to spare.
void add_water_factor(const limit::LimitAnalysis& structure, Situation& now, const limit::Wrenches& stated,
                      const limit::LimitStrength& strength, nlohmann::json& answer);

/// Anchors stretch as blocks move, and motion up to [analysis] failure_displacement_m is none of failure. Warns where
/// the factor is another one with a tenth of that way.
void add_stretch_of_anchors(Situation& now, const StaticStrength& found, nlohmann::json& answer);

/// Warns of bonds that their tension holds. Where their cohesion counts, "with_cracked_joint" is the factor by limit
/// analysis with cohesion on the compressed part of such joints alone.
void add_cracked_joints(const Solid& blocks, Situation& now, nlohmann::json& answer);

}  // namespace blockweir::solid
