// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/level_range.hpp"

#include <algorithm>
#include <limits>

namespace blockweir::solid::limit {

LevelRange level_range(const scene::Scene& scene) {
  double bottom = std::numeric_limits<double>::infinity();
  double foot = bottom;
  double crest = -bottom;
  for (const scene::Block& block : scene.blocks) {
    for (const scene::Point& p : block.vertices) {
      bottom = std::min(bottom, p.y());
      if (block.fixed) continue;
      foot = std::min(foot, p.y());
      crest = std::max(crest, p.y());
    }
  }
  return {bottom, scene.water.may_overtop ? 2 * crest - foot : crest};
}

}  // namespace blockweir::solid::limit
