// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/structure_size.hpp"

#include <Eigen/Geometry>

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

}  // namespace blockweir::scene
