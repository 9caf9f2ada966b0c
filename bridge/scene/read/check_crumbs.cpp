// SPDX-License-Identifier: GPL-3.0-or-later
// Crumbs among the blocks: they cost as much as others, and move before those that matter.
#include <fmt/format.h>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/crumbs.hpp"
#include "bridge/scene/read/magnitudes.hpp"

namespace blockweir::scene {

void check_crumbs(const Scene& scene, Problems& problems) {
  const std::vector<bool> small = crumbs(scene.blocks);
  const Block* smallest = nullptr;
  double least_m2 = 0;
  std::size_t count = 0;
  for (std::size_t b = 0; b < small.size(); ++b) {
    if (!small[b]) continue;
    ++count;
    const double area_m2 = geometry::signed_area(scene.blocks[b].vertices);
    if (smallest != nullptr && area_m2 >= least_m2) continue;
    smallest = &scene.blocks[b];
    least_m2 = area_m2;
  }
  if (smallest == nullptr) return;
  const std::string found = count == 1 ? fmt::format("block \"{}\" of {:.2g} m2 is a crumb", smallest->name, least_m2)
                                       : fmt::format("{} blocks are crumbs, the smallest \"{}\" of {:.2g} m2", count,
                                                     smallest->name, least_m2);
  problems.warning(problems.at(smallest->line),
                   found + ", which is unusual: a verdict names it only where nothing else moves",
                   "blocks above a ten-thousandth of the median block's area",
                   "shift the joints that cut it out, as by offset_m of a [[joint_set]], or cut otherwise");
}

}  // namespace blockweir::scene
