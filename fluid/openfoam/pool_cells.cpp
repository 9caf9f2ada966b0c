// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/pool_cells.hpp"

#include <algorithm>
#include <deque>
#include <limits>

#include "fluid/openfoam/polygon_clip.hpp"
#include "fluid/openfoam/sample_points.hpp"

namespace blockweir::openfoam {
namespace {

Polygon outline_of(const Grid& g, std::size_t cell) {
  const std::size_t i = cell % g.columns();
  const std::size_t j = cell / g.columns();
  return {{g.x[i], g.y[j]}, {g.x[i + 1], g.y[j]}, {g.x[i + 1], g.y[j + 1]}, {g.x[i], g.y[j + 1]}};
}

/// Spreads what the cells of `front` hold to their unknown neighbours that `may_enter`.
template <class MayEnter>
void spread(const Grid& g, std::deque<std::size_t> front, std::vector<Holds>& holds, MayEnter may_enter) {
  while (!front.empty()) {
    const std::size_t cell = front.front();
    front.pop_front();
    const std::size_t i = cell % g.columns();
    const std::size_t j = cell / g.columns();
    const auto visit = [&](bool inside, std::size_t next) {
      if (!inside || holds[next] != Holds::unknown || !may_enter(next, holds[cell])) return;
      holds[next] = holds[cell];
      front.push_back(next);
    };
    visit(i > 0, cell - 1);
    visit(i + 1 < g.columns(), cell + 1);
    visit(j > 0, cell - g.columns());
    visit(j + 1 < g.rows(), cell + g.columns());
  }
}

/// The highest vertex of the structure nearest to the pool: where water above the crest ends at time 0.
scene::Point crest(const Grid& g, const scene::Scene& scene, bool upstream) {
  scene::Point crest(0, -std::numeric_limits<double>::infinity());
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    if (g.site.is_ground(b)) continue;
    for (const scene::Point& p : scene.blocks[b].vertices) {
      const bool nearer = upstream ? p.x() < crest.x() : p.x() > crest.x();
      if (p.y() > crest.y() || (p.y() == crest.y() && nearer)) crest = p;
    }
  }
  return crest;
}

/// The pool that reaches into a cell; air if none does. An almost full cell may contain a crack, whose content is that
/// of its neighbours.
Holds pool_in(const Grid& g, std::size_t cell, double filled, const std::vector<ExactPool>& pools, PolygonClip& clip) {
  constexpr double crossed = 0.95;
  constexpr double least = 1e-6;
  const Polygon outline = outline_of(g, cell);
  for (const ExactPool& pool : pools) {
    if (outline.front().y() >= pool.level_m) continue;
    double share = 0;
    for (const Polygon& ring : pool.faces.region) share += clip.common_area(ring, outline);
    if (share > least * area(outline)) {
      return pool.pool == hydrostatic::Pool::upstream ? Holds::upstream : Holds::downstream;
    }
  }
  return filled < crossed ? Holds::air : Holds::unknown;
}

}  // namespace

std::vector<double> filled_cells(const Grid& g, const std::vector<std::vector<scene::Point>>& outlines) {
  std::vector<double> filled(g.cells(), 0);
  PolygonClip clip;
  const auto first = [](const std::vector<double>& lines, double v) {
    const auto after = std::upper_bound(lines.begin(), lines.end(), v);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - lines.begin() - 1));
  };
  for (const Polygon& outline : outlines) {
    const geometry::Bounds box = geometry::bounds_of(outline);
    for (std::size_t j = first(g.y, box.low.y()); j < g.rows() && g.y[j] < box.high.y(); ++j) {
      for (std::size_t i = first(g.x, box.low.x()); i < g.columns() && g.x[i] < box.high.x(); ++i) {
        const std::size_t cell = j * g.columns() + i;
        const Polygon window = outline_of(g, cell);
        filled[cell] += clip.common_area(outline, window) / area(window);
      }
    }
  }
  return filled;
}

std::vector<Holds> pool_cells(const Grid& g, const scene::Scene& scene, const std::vector<double>& filled,
                              const std::vector<ExactPool>& pools) {
  const PoolLevels levels = levels_at_start(scene);
  const scene::Point up_to = crest(g, scene, true);
  const scene::Point from = crest(g, scene, false);
  const auto is_water = [&](std::size_t cell, Holds pool) {
    const std::size_t i = cell % g.columns();
    const double bottom = g.y[cell / g.columns()];
    const double x = (g.x[i] + g.x[i + 1]) / 2;
    if (filled[cell] > untouched) return false;
    if (pool == Holds::upstream) return bottom < levels.upstream_m && (bottom < up_to.y() || x < up_to.x());
    return bottom < levels.downstream_m && (bottom < from.y() || x > from.x());
  };
  std::vector<Holds> holds(g.cells(), Holds::unknown);
  std::deque<std::size_t> front;
  for (std::size_t j = 0; j < g.rows(); ++j) {
    for (const auto& [cell, pool] :
         {std::pair(j * g.columns(), Holds::upstream), std::pair((j + 1) * g.columns() - 1, Holds::downstream)}) {
      if (!is_water(cell, pool)) continue;
      holds[cell] = pool;
      front.push_back(cell);
    }
  }
  spread(g, std::move(front), holds, is_water);
  front.clear();
  PolygonClip clip;
  for (std::size_t cell = 0; cell < g.cells(); ++cell) {
    const bool unknown = holds[cell] == Holds::unknown && filled[cell] < sealed;
    if (unknown) holds[cell] = pool_in(g, cell, filled[cell], pools, clip);
    if (holds[cell] != Holds::unknown) front.push_back(cell);
  }
  spread(g, std::move(front), holds, [](std::size_t, Holds) { return true; });
  return holds;
}

}  // namespace blockweir::openfoam
