// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of the model where the ground continues: the model's faces there are cuts, and no water touches them.
#pragma once

#include <optional>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// The bed starts at this corner; beyond the model's end it continues level.
struct BedCorner {
  int block = 0;
  int vertex = 0;
};

struct GroundEnds {
  std::optional<BedCorner> left;
  std::optional<BedCorner> right;
};

/// Finds the ground ends. A stack of upright faces on an end of the model counts as ground if all of these hold: it
/// stands on a fixed or supported block; its top is below the highest level and below the structure's crest; the bed on
/// top rises inward by no more than 1 in 4 over half of the stack's height or more. `[water] wets_ends` overrides this:
/// true: no face is ground; false: every end below level and crest is.
GroundEnds find_ground_ends(const Scene& scene);

/// Whether the model's lowest block is lighter than water and neither fixed nor supported, so that water is under it.
bool lowest_floats(const Scene& scene);

}  // namespace blockweir::scene
