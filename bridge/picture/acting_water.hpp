// SPDX-License-Identifier: GPL-3.0-or-later
// The loads of the water on a section, by kind with their resultants, for pictures.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// Adds an entry for each, as of acting_loads(), to `list`.
void put_water(const scene::Scene& scene, const nlohmann::json& water, nlohmann::json& list);

}  // namespace blockweir::picture
