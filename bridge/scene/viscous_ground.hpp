// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that belong to ground that continues beyond the model.
#pragma once

#include <algorithm>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Whether the block has a viscous face.
inline bool is_viscous_ground(const Scene& scene, int block) {
  return std::any_of(scene.viscous_faces.begin(), scene.viscous_faces.end(),
                     [&](const ViscousFace& face) { return face.block == block; });
}

/// Whether a viscous face carries the block from below.
inline bool rests_on_viscous_ground(const Scene& scene, int block) {
  return std::any_of(scene.viscous_faces.begin(), scene.viscous_faces.end(),
                     [&](const ViscousFace& face) { return face.block == block && !face.is_side(); });
}

}  // namespace blockweir::scene
