// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that a scene has where blocks touch, whether or not it states them.
#pragma once

#include <set>
#include <utility>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Pairs of blocks, the lower index first, that share a part of their outlines, of which one at least is not fixed.
/// What is nearer than `touching_m` touches.
std::set<std::pair<int, int>> touching_pairs(const Scene& scene, double touching_m);

}  // namespace blockweir::scene
