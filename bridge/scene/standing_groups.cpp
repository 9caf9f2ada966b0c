// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/standing_groups.hpp"

#include <algorithm>
#include <limits>

#include "bridge/scene/at.hpp"
#include "bridge/scene/block_index.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {

bool StandingGroups::on_ground(std::size_t block) const {
  return of_block[block] >= 0 && all[at(of_block[block])].on_ground;
}

StandingGroups standing_groups(const std::vector<Block>& blocks) {
  constexpr double touching = 1e-6;  // of the structure
  constexpr double none = std::numeric_limits<double>::infinity();
  const Point margin = Point::Constant(touching * structure_size_m(blocks));
  const BlockIndex index(blocks);
  StandingGroups groups{{}, std::vector<int>(blocks.size(), -1)};
  std::vector<std::size_t> next;
  for (std::size_t first = 0; first < blocks.size(); ++first) {
    if (blocks[first].fixed || groups.of_block[first] >= 0 || blocks[first].vertices.empty()) continue;
    const int number = static_cast<int>(groups.all.size());
    StandingGroup& group = groups.all.emplace_back(StandingGroup{none, -none, -1, false});
    groups.of_block[first] = number;
    for (next = {first}; !next.empty();) {
      const std::size_t b = next.back();
      next.pop_back();
      const geometry::Bounds box = geometry::bounds_of(blocks[b].vertices);
      group.foot_m = std::min(group.foot_m, box.low.y());
      if (box.high.y() > group.top_m) group.top_m = box.high.y(), group.highest = static_cast<int>(b);
      for (const std::size_t other : index.meeting({box.low - margin, box.high + margin})) {
        if (blocks[other].fixed) group.on_ground = true;
        if (blocks[other].fixed || groups.of_block[other] >= 0) continue;
        groups.of_block[other] = number;
        next.push_back(other);
      }
    }
  }
  const auto stands = [](const StandingGroup& group) { return group.on_ground; };
  if (std::none_of(groups.all.begin(), groups.all.end(), stands)) {
    for (StandingGroup& group : groups.all) group.on_ground = true;
  }
  return groups;
}

std::vector<bool> retaining_blocks(const std::vector<Block>& blocks) {
  const StandingGroups groups = standing_groups(blocks);
  std::vector<bool> retaining;
  for (std::size_t b = 0; b < blocks.size(); ++b) retaining.push_back(blocks[b].fixed || groups.on_ground(b));
  return retaining;
}

double retaining_top_m(const StandingGroups& groups) {
  double top_m = -std::numeric_limits<double>::infinity();
  for (const StandingGroup& group : groups.all) {
    if (group.on_ground) top_m = std::max(top_m, group.top_m);
  }
  return top_m;
}

}  // namespace blockweir::scene
