// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that stand on one corner: drawn so by mistake, or as a puzzle that no analysis can answer.
#include <fmt/format.h>

#include "bridge/geometry/place_text.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/corner_stands.hpp"
#include "bridge/scene/read/magnitudes.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {

void check_corner_stands(const Scene& scene, Problems& problems) {
  // Without gravity nothing falls; blocks that start without stress are probably thrown or dropped.
  if (scene.analysis.gravity_m_per_s2 == 0 || scene.analysis.start == Start::unstressed) return;
  for (const CornerStand& stand : corner_stands(scene)) {
    const Block& block = scene.blocks[at(stand.block)];
    problems.warning(problems.at(block.line),
                     fmt::format("block \"{}\" touches other blocks at one corner alone, at {} m, which is unusual for "
                                 "a structure that begins at rest: the smallest push turns it over",
                                 block.name, geometry::place_text(stand.at_m, structure_size_m(scene.blocks))),
                     "faces that meet, or corners at two places",
                     "draw it so that it stands on a face, or state the [[support]] or [[bolt]] that holds it");
  }
}

}  // namespace blockweir::scene
