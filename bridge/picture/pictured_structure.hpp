// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a scene that its pictures are about: the dam, not the wide rock on which it stands.
#pragma once

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// The box around the movable blocks that rise above the ground at both ends of the model [m]. Where none does: around
/// all movable blocks, and where nothing moves, around all blocks.
[[nodiscard]] geometry::Bounds pictured_structure(const scene::Scene& scene);

}  // namespace blockweir::picture
