// SPDX-License-Identifier: GPL-3.0-or-later
// The levels of a filling reservoir, and the possible outcomes for the structure.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid::limit {

struct LevelRange {
  double empty_m = 0;  ///< the model's lowest vertex
  double full_m = 0;   ///< the crest; with overtopping, as high above the crest as the crest is above the base
  std::vector<double> lower_tops_m{};  ///< just below those of lower structures on the ground, ascending
};
LevelRange level_range(const scene::Scene& scene);

enum class Filled { fails, stands_full, does_not_stand_empty };

}  // namespace blockweir::solid::limit
