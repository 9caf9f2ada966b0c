// SPDX-License-Identifier: GPL-3.0-or-later
// Which blocks are part of ground that goes on beyond the model.
#pragma once

#include <algorithm>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Has the block a viscous face?
inline bool is_viscous_ground(const Scene& scene, int block) {
  return std::any_of(scene.viscous_faces.begin(), scene.viscous_faces.end(),
                     [&](const ViscousFace& face) { return face.block == block; });
}

/// Has it one that bears it?
inline bool rests_on_viscous_ground(const Scene& scene, int block) {
  return std::any_of(scene.viscous_faces.begin(), scene.viscous_faces.end(),
                     [&](const ViscousFace& face) { return face.block == block && !face.is_side(); });
}

}  // namespace blockweir::scene
