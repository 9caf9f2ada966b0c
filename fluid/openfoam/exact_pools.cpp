// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/exact_pools.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::openfoam {

PoolLevels levels_at_start(const scene::Scene& scene) {
  const auto start = [](const std::optional<scene::TimeTable>& level) {
    return level ? level->at(0) : -std::numeric_limits<double>::infinity();
  };
  return {start(scene.water.upstream_level_m), start(scene.water.downstream_level_m)};
}

double ExactPool::depth(const scene::Point& p) const {
  return std::max(0.0, level_m - p.y());
}

bool ExactPool::holds(const scene::Point& p) const {
  return p.y() < level_m && within(faces.region, p);
}

std::vector<ExactPool> exact_pools(const scene::Scene& scene, const Grid& grid,
                                   std::vector<std::vector<scene::Point>> outlines) {
  const double floor = grid.y.front();
  if (floor < grid.site.model.low.y()) {  // water can be under the lowest block
    const double left = grid.x.front();
    const double right = grid.x.back();
    outlines.push_back({{left, floor - 1}, {right, floor - 1}, {right, floor}, {left, floor}});
  }
  const PoolLevels levels = levels_at_start(scene);
  std::vector<ExactPool> pools;
  for (const auto& [level, pool] : {std::pair(levels.upstream_m, hydrostatic::Pool::upstream),
                                    std::pair(levels.downstream_m, hydrostatic::Pool::downstream)}) {
    if (!std::isfinite(level)) continue;
    pools.push_back({pool, level, hydrostatic::wet_faces({outlines, scene.water.open_crack_width_m}, pool, level)});
  }
  return pools;
}

bool within(const std::vector<std::vector<scene::Point>>& rings, const scene::Point& p) {
  bool inside = false;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const scene::Point& a = ring[i];
      const scene::Point& b = ring[(i + 1) % ring.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
  }
  return inside;
}

}  // namespace blockweir::openfoam
