// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/structure_size.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace blockweir::scene {

double structure_size_m(const std::vector<Block>& blocks) {
  Eigen::AlignedBox2d movable;
  Eigen::AlignedBox2d all;
  for (const Block& block : blocks) {
    for (const Point& vertex : block.vertices) {
      all.extend(vertex);
      if (!block.fixed) movable.extend(vertex);
    }
  }
  if (all.isEmpty()) return 1;
  return (movable.isEmpty() ? all : movable).sizes().maxCoeff();
}

double typical_width_m(const std::vector<Block>& blocks) {
  std::vector<double> widths;
  for (const Block& block : blocks) {
    Eigen::AlignedBox2d box;
    for (const Point& vertex : block.vertices) box.extend(vertex);
    if (!block.fixed && !box.isEmpty()) widths.push_back(box.sizes().minCoeff());
  }
  if (widths.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  return *middle;
}

}  // namespace blockweir::scene
