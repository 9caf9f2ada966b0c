// SPDX-License-Identifier: GPL-3.0-or-later
// A reservoir that is filled, and what may become of a structure meanwhile.
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::solid::limit {

struct LevelRange {
  double empty_m = 0;  ///< the model's lowest vertex
  double full_m = 0;   ///< the crest, or as high above it as it is high where the scene lets water overtop it
};
LevelRange level_range(const scene::Scene& scene);

enum class Filled { fails, stands_full, does_not_stand_empty };

}  // namespace blockweir::solid::limit
