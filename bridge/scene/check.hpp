// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene that reads well may still have wrong: geometry, supports, levels.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/scene/table_reader.hpp"

namespace blockweir::scene {

/// Adds to `problems` all that is geometrically or physically unsound.
void check(const Scene& scene, Problems& problems);

}  // namespace blockweir::scene
