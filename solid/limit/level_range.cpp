// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/level_range.hpp"

#include <algorithm>
#include <limits>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/standing_groups.hpp"

namespace blockweir::solid::limit {

LevelRange level_range(const scene::Scene& scene) {
  const scene::StandingGroups groups = scene::standing_groups(scene.blocks);
  const double crest_m = scene::retaining_top_m(groups);
  LevelRange range{.empty_m = std::numeric_limits<double>::infinity(), .full_m = crest_m};
  for (const scene::Block& block : scene.blocks) {
    range.empty_m = std::min(range.empty_m, geometry::bounds_of(block.vertices).low.y());
  }
  double foot_m = std::numeric_limits<double>::infinity();
  for (const scene::StandingGroup& group : groups.all) {
    if (group.on_ground) foot_m = std::min(foot_m, group.foot_m);
  }
  if (scene.water.may_overtop) range.full_m = 2 * crest_m - foot_m;
  constexpr double below = 1e-3;  // of its height: a top that settles is not to be drowned yet
  for (const scene::StandingGroup& group : groups.all) {
    if (!group.on_ground || group.top_m >= range.full_m) continue;
    range.lower_tops_m.push_back(group.top_m - below * (group.top_m - group.foot_m));
  }
  std::sort(range.lower_tops_m.begin(), range.lower_tops_m.end());
  return range;
}

}  // namespace blockweir::solid::limit
