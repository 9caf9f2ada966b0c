// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a scene that pictures show: the dam, without the wide rock below it.
#pragma once

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// Bounding box of the moving blocks that are higher than the ground at both ends of the model [m]. If there are none:
/// of all moving blocks, and if nothing moves, of all blocks.
[[nodiscard]] geometry::Bounds pictured_structure(const scene::Scene& scene);

}  // namespace blockweir::picture
