// SPDX-License-Identifier: GPL-3.0-or-later
// Where the model ends in ground that goes on: its faces there are cuts, and no water stands beside them.
#pragma once

#include <optional>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// The bed begins at this corner, and beyond the model's end it goes on level.
struct BedCorner {
  int block = 0;
  int vertex = 0;
};

struct GroundEnds {
  std::optional<BedCorner> left;
  std::optional<BedCorner> right;
};

/// The upright faces on an end of the model, one on the other from the lowest up, are the ground's where they stand on
/// a block that is fixed or supported, their top lies below the highest level and below the structure's crest, and the
/// bed on it leads inward, rising by no more than 1 in 4, for half of their height or more. `[water] wets_ends` decides
/// otherwise: true, nothing is ground; false, all that ends below level and crest is.
GroundEnds find_ground_ends(const Scene& scene);

/// Whether the model's lowest block is lighter than water and neither fixed nor supported: then water is below it, too.
bool lowest_floats(const Scene& scene);

}  // namespace blockweir::scene
