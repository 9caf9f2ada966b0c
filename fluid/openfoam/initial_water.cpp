// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/initial_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fluid/openfoam/polygon_clip.hpp"
#include "fluid/openfoam/pool_cells.hpp"
#include "fluid/openfoam/solitary_wave.hpp"

namespace blockweir::openfoam {
namespace {

Polygon cell_polygon(const Grid& g, std::size_t i, std::size_t j) {
  return {{g.x[i], g.y[j]}, {g.x[i + 1], g.y[j]}, {g.x[i + 1], g.y[j + 1]}, {g.x[i], g.y[j + 1]}};
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
  const PoolLevels levels = levels_at_start(scene);
  const double upstream = levels.upstream_m;
  const double downstream = levels.downstream_m;
  const auto outlines = outlines_in(g, scene);
  const auto holds = pool_cells(g, scene, filled_cells(g, outlines), exact_pools(scene, g, outlines));

  InitialWater water;
  water.reference_level_m = std::max(upstream, downstream);
  if (std::isfinite(upstream)) water.reference_level_m = upstream;
  for (const auto& drawn : scene.openfoam.initial_water_m) {
    if (!std::isfinite(water.reference_level_m)) water.reference_level_m = geometry::bounds_of(drawn).high.y();
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
