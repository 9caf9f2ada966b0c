// SPDX-License-Identifier: GPL-3.0-or-later
// The same scene with its blocks listed in another order. Where equilibrium does not determine friction, which forces
// blocks find may depend on it.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// `order`: the present indices of the blocks, one after the other. All that refers to a block by its index refers to
/// the same block afterwards.
Scene reordered(Scene scene, const std::vector<int>& order);

/// Indices of the blocks by the x of their middles, from left to right; of those above each other, upwards or
/// downwards.
std::vector<int> from_left_to_right(const Scene& scene, bool upwards);

}  // namespace blockweir::scene
