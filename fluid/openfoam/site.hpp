// SPDX-License-Identifier: GPL-3.0-or-later
// Where the structure stands: what any mesh around it has to know of the scene.
#pragma once

#include <vector>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::openfoam {

struct Site {
  geometry::Bounds model;   ///< of all blocks
  double highest_m = 0;     ///< that water reaches by its levels, or is drawn to
  std::vector<int> ground;  ///< fixed blocks that go on level beyond the model's ends
  double bed_left_m = 0;    ///< top of the ground there, loose blocks on a fixed one among it; minus infinity: none
  double bed_right_m = 0;
  double loose_left_m = 0;  ///< extent of all blocks but the ground
  double loose_right_m = 0;
  double structure_left_m = 0;  ///< extent of those that stand on the bed
  double structure_right_m = 0;

  [[nodiscard]] bool is_ground(std::size_t block) const;
};

Site find_site(const scene::Scene& scene);

/// Outlines of all blocks, those of the ground drawn out to both ends, as high there as the bed.
std::vector<std::vector<scene::Point>> outlines_up_to(double left_m, double right_m, const Site& site,
                                                      const scene::Scene& scene);

}  // namespace blockweir::openfoam
