// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what acts on a scene's blocks changes while it is computed.
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Still water whose upstream or downstream level is the same throughout; false without such a pool.
bool level_is_constant(const Scene& scene, bool downstream);

/// No level, load, support or ground changes or moves.
bool loads_are_constant(const Scene& scene);

}  // namespace blockweir::scene
