// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/crumbs.hpp"

#include <algorithm>

#include "bridge/geometry/polygon.hpp"

namespace blockweir::scene {

std::vector<bool> crumbs(const std::vector<Block>& blocks) {
  constexpr double of_median = 1e-4;
  std::vector<double> areas;
  for (const Block& block : blocks) {
    if (!block.fixed) areas.push_back(geometry::signed_area(block.vertices));
  }
  std::vector<bool> small(blocks.size(), false);
  if (areas.empty()) return small;
  // Of two in the middle the larger: beside a single dam a crumb would be its own measure.
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::nth_element(areas.begin(), middle, areas.end());
  const double least = of_median * *middle;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    small[b] = !blocks[b].fixed && geometry::signed_area(blocks[b].vertices) < least;
  }
  return small;
}

}  // namespace blockweir::scene
