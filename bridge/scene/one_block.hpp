// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that a scene fits formulas for a single block on a joint with one pool.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// What the scene has besides the joint's upper block and the upstream pool, for a message; empty: nothing.
[[nodiscard]] std::string beyond_one_block(const Scene& scene, const Joint& joint);

}  // namespace blockweir::scene
