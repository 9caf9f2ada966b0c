// SPDX-License-Identifier: GPL-3.0-or-later
// What answers of level and of safety have in common.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/limit/mechanism_words.hpp"

namespace blockweir::solid {

/// In words, with the motion of each block that moves.
nlohmann::json mechanism_json(const limit::LimitAnalysis& structure, const limit::Twists& mechanism);

/// Says after whom the water answers to an earthquake, where the scene has one.
void add_water_in_an_earthquake(const scene::Scene& scene, nlohmann::json& answer);

/// Has some joint a bond that slip or tension can break: cohesion, tension strength, a peak friction?
bool has_bonds(const scene::Scene& scene);

/// Does some block that can move strain?
bool strains(const scene::Scene& scene);
/// The same scene with rigid blocks.
scene::Scene with_rigid_blocks(scene::Scene scene);

}  // namespace blockweir::solid
