// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of a structure of several blocks that touches nothing that holds it: it drops before it stands.
#include <fmt/format.h>

#include "bridge/scene/at.hpp"
#include "bridge/scene/loose_blocks.hpp"
#include "bridge/scene/read/magnitudes.hpp"

namespace blockweir::scene {

void check_hovering(const Scene& scene, Problems& problems) {
  if (scene.analysis.start == Start::unstressed) return;  // probably meant to drop
  const std::vector<int> loose = blocks_not_held(scene);
  if (loose.size() < 2) return;  // a stone may be let fall
  problems.warning(problems.at(scene.blocks[at(loose.front())].line),
                   loose_text(scene, loose) + ", as they touch nothing that holds them, which is unusual",
                   "blocks that rest on a fixed block or a support",
                   "move them onto it; if they are to drop, set start = \"unstressed\"");
}

}  // namespace blockweir::scene
