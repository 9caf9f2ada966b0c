// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/crest.hpp"

#include <algorithm>
#include <limits>

#include "bridge/scene/standing_groups.hpp"

namespace blockweir::scene {

Crest crest_of(const std::vector<Block>& blocks, const std::vector<std::vector<Point>>& outlines) {
  constexpr double level = 2e-3;  // of the height of all
  constexpr double none = std::numeric_limits<double>::infinity();
  const StandingGroups groups = standing_groups(blocks);
  Crest crest{-none, -none, none, -none, {}};
  double lowest = none;
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    for (const Point& p : outlines[b]) {
      lowest = std::min(lowest, p.y());
      if (groups.on_ground(b)) crest.height_m = std::max(crest.height_m, p.y());
    }
  }
  crest.low_m = crest.height_m - level * (crest.height_m - lowest);
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    const auto& outline = outlines[b];
    for (std::size_t e = 0; e < outline.size(); ++e) {
      const Point& right = outline[e];  // what lies under an edge lies on its left
      const Point& left = outline[(e + 1) % outline.size()];
      if (!groups.on_ground(b) || right.y() < crest.low_m) continue;
      crest.left_m = std::min(crest.left_m, right.x());
      crest.right_m = std::max(crest.right_m, right.x());
      if (left.x() >= right.x() || left.y() < crest.low_m) continue;
      crest.edges.push_back({static_cast<int>(b), static_cast<int>(e), left.x(), right.x()});
    }
  }
  return crest;
}

Crest crest_of(const std::vector<Block>& blocks) {
  std::vector<std::vector<Point>> outlines;
  for (const Block& block : blocks) outlines.push_back(block.vertices);
  return crest_of(blocks, outlines);
}

}  // namespace blockweir::scene
