// SPDX-License-Identifier: GPL-3.0-or-later
// The surroundings of the structure that any mesh needs.
#pragma once

#include <vector>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::openfoam {

struct Site {
  geometry::Bounds model;   ///< of all blocks
  double highest_m = 0;     ///< highest point that water can reach, by level or as drawn
  std::vector<int> ground;  ///< fixed blocks that continue level beyond the model's ends
  double bed_left_m = 0;    ///< top of the ground there, with loose blocks on it; minus infinity: none
  double bed_right_m = 0;
  double loose_left_m = 0;  ///< extent of all blocks except the ground
  double loose_right_m = 0;
  double structure_left_m = 0;  ///< extent of the blocks on the bed
  double structure_right_m = 0;

  [[nodiscard]] bool is_ground(std::size_t block) const;
};

Site find_site(const scene::Scene& scene);

/// Outlines of all blocks; those of the ground are extended to both ends at the bed's elevation.
std::vector<std::vector<scene::Point>> outlines_up_to(double left_m, double right_m, const Site& site,
                                                      const scene::Scene& scene);

}  // namespace blockweir::openfoam
