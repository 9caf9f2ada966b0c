// SPDX-License-Identifier: GPL-3.0-or-later
// What blocks that are sound each for itself may still have wrong together.
#pragma once

#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Of a block's size: coordinates in files are rounded, and what is nearer touches.
constexpr double rounding_ratio = 1e-6;

/// Reports blocks that overlap deeper than 1e-6 of the smaller one's size. Blocks without vertices are passed over.
void check_overlaps(const Scene& scene, Problems& problems);

/// Reports, in one error, the blocks that would fall for ever. A block is held if it is fixed, if a support holds a
/// point of it in y, if a bolt ties it to the ground or to a block that is held, if its material is lighter than the
/// scene's water, or if it shares a boundary with a block that is held or lies vertically above a part of one. Without
/// gravity nothing falls.
void check_held(const Scene& scene, Problems& problems);

}  // namespace blockweir::scene
