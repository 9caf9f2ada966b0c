// SPDX-License-Identifier: GPL-3.0-or-later
// For a run longer than its scene states: ramps without `to` still end at the scene's own duration.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Settings "key.to=value", one for each ramp of the scene without `to`.
std::vector<std::string> ramp_ends(const Scene& scene);

}  // namespace blockweir::scene
