// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/initial_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <stdexcept>

#include "fluid/openfoam/polygon_clip.hpp"
#include "fluid/openfoam/solitary_wave.hpp"

namespace blockweir::openfoam {
namespace {

enum class Holds : char { unknown, air, upstream, downstream };

Polygon cell_polygon(const Grid& g, std::size_t i, std::size_t j) {
  return {{g.x[i], g.y[j]}, {g.x[i + 1], g.y[j]}, {g.x[i + 1], g.y[j + 1]}, {g.x[i], g.y[j + 1]}};
}

/// Cells of which blocks fill more than half.
std::vector<bool> solid_cells(const Grid& g, const std::vector<Polygon>& outlines) {
  std::vector<double> filled(g.cells(), 0);
  PolygonClip clip;
  const auto first = [](const std::vector<double>& lines, double v) {
    const auto after = std::upper_bound(lines.begin(), lines.end(), v);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - lines.begin() - 1));
  };
  for (const Polygon& outline : outlines) {
    const scene::Bounds box = scene::bounds_of(outline);
    for (std::size_t j = first(g.y, box.low.y()); j < g.rows() && g.y[j] < box.high.y(); ++j) {
      for (std::size_t i = first(g.x, box.low.x()); i < g.columns() && g.x[i] < box.high.x(); ++i) {
        const Polygon cell = cell_polygon(g, i, j);
        filled[j * g.columns() + i] += clip.common_area(outline, cell) / area(cell);
      }
    }
  }
  std::vector<bool> solid(g.cells());
  std::transform(filled.begin(), filled.end(), solid.begin(), [](double f) { return f > 0.5; });
  return solid;
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

/// Water that the scene draws. Its pressure is interFoam's to find: it is not at rest.
void add_drawn(const Grid& g, const scene::Scene& scene, std::vector<double>& fraction) {
  PolygonClip clip;
  for (const auto& outline : scene.openfoam.initial_water_m) {
    for (std::size_t cell = 0; cell < g.cells(); ++cell) {
      const Polygon window = cell_polygon(g, cell % g.columns(), cell / g.columns());
      const double share = clip.common_area(outline, window) / area(window);
      fraction[cell] = std::min(1.0, fraction[cell] + share);
    }
  }
}

/// Between the mesh's end and the structure, out of reach of both.
std::optional<SolitaryWave> solitary_wave(const Grid& g, const scene::Scene& scene, double level) {
  const auto& wave = scene.openfoam.wave;
  if (!wave || wave->kind != scene::WaveKind::solitary) return std::nullopt;
  SolitaryWave solitary{wave->height_m, level - g.ground_m, 0, scene.analysis.gravity_m_per_s2};
  solitary.crest_x_m = g.site.structure_left_m - solitary.reach_m();
  const double room = g.site.structure_left_m - g.x.front();
  if (room < 2 * solitary.reach_m()) {
    throw std::invalid_argument(
        fmt::format("OpenFOAM: the solitary wave is {:.4g} m long, and there are {:.4g} m before the structure; raise "
                    "upstream_depths "
                    "in [fluid] to {:.3g}",
                    2 * solitary.reach_m(), room, std::ceil(2 * solitary.reach_m() / solitary.depth_m)));
  }
  return solitary;
}

}  // namespace

InitialWater initial_water(const Grid& g, const scene::Scene& scene) {
  const auto start = [](const std::optional<scene::TimeTable>& level) {
    return level ? level->at(0) : -std::numeric_limits<double>::infinity();
  };
  const double upstream = start(scene.water.upstream_level_m);
  const double downstream = start(scene.water.downstream_level_m);
  const std::vector<bool> solid = solid_cells(g, outlines_in(g, scene));
  const scene::Point up_to = crest(g, scene, true);
  const scene::Point from = crest(g, scene, false);

  std::vector<Holds> holds(g.cells(), Holds::unknown);
  const auto is_water = [&](std::size_t cell, Holds pool) {
    const std::size_t i = cell % g.columns();
    const double bottom = g.y[cell / g.columns()];
    const double x = (g.x[i] + g.x[i + 1]) / 2;
    if (solid[cell]) return false;
    if (pool == Holds::upstream) return bottom < upstream && (bottom < up_to.y() || x < up_to.x());
    return bottom < downstream && (bottom < from.y() || x > from.x());
  };
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
  for (std::size_t cell = 0; cell < g.cells(); ++cell) {
    if (solid[cell]) continue;
    if (holds[cell] == Holds::unknown) holds[cell] = Holds::air;
    front.push_back(cell);
  }
  spread(g, std::move(front), holds, [](std::size_t, Holds) { return true; });

  InitialWater water;
  water.reference_level_m = std::max(upstream, downstream);
  if (std::isfinite(upstream)) water.reference_level_m = upstream;
  for (const auto& drawn : scene.openfoam.initial_water_m) {
    if (!std::isfinite(water.reference_level_m)) water.reference_level_m = scene::bounds_of(drawn).high.y();
  }
  const double buoyancy =
      (scene.water.density_kg_per_m3 - scene.openfoam.air_density_kg_per_m3) * scene.analysis.gravity_m_per_s2;
  const auto wave = solitary_wave(g, scene, upstream);
  if (wave) water.velocity.assign(g.cells(), scene::Point::Zero());
  for (std::size_t cell = 0; cell < g.cells(); ++cell) {
    const std::size_t i = cell % g.columns();
    const double x = (g.x[i] + g.x[i + 1]) / 2;
    const double raised = wave && x < g.site.structure_left_m ? wave->elevation(x) : 0;
    const double level = holds[cell] == Holds::downstream               ? downstream
                         : holds[cell] == Holds::upstream || raised > 0 ? upstream + raised
                                                                        : -std::numeric_limits<double>::infinity();
    const std::size_t j = cell / g.columns();
    const double height = g.y[j + 1] - g.y[j];
    const double fraction = std::clamp((level - g.y[j]) / height, 0.0, 1.0);
    water.fraction.push_back(fraction);
    // Still to the last digit: in a cell that the surface cuts, what interFoam's own balance across its faces leaves.
    const double head = fraction * (level - water.reference_level_m + (1 - fraction) * height);
    water.p_rgh_pa.push_back(fraction > 0 ? buoyancy * head : 0);
    const double y = (g.y[j] + g.y[j + 1]) / 2;
    if (raised > 0 && y > g.ground_m && fraction > 0.5) water.velocity[cell] = wave->velocity(x, y - g.ground_m);
  }
  add_drawn(g, scene, water.fraction);
  return water;
}

}  // namespace blockweir::openfoam
