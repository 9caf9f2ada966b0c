// SPDX-License-Identifier: GPL-3.0-or-later
// A run that is to last longer than its scene says: ramps without `to` end where the scene's own duration ends them.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Settings "key.to=value", one for each ramp of the scene that states no `to`.
std::vector<std::string> ramp_ends(const Scene& scene);

}  // namespace blockweir::scene
