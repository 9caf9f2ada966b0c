// SPDX-License-Identifier: GPL-3.0-or-later
// What formulas leave out that know one block on a joint and one pool.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// What the scene has beyond the upper block of this joint and the upstream pool, in words; empty: nothing.
[[nodiscard]] std::string beyond_one_block(const Scene& scene, const Joint& joint);

}  // namespace blockweir::scene
