// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/water_on_crest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bridge/scene/hydrostatics.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::solid::output {
namespace {

constexpr double none = -std::numeric_limits<double>::infinity();

double crest_m(const scene::Scene& scene) {
  double crest = none;
  for (const scene::Block& block : scene.blocks) {
    if (block.fixed) continue;
    for (const Point& p : block.vertices) crest = std::max(crest, p.y());
  }
  return crest;
}

/// Highest level from time 0 to `end_s` above a crest that the other pool does not reach.
double highest_alone_m(const scene::Water& water, double crest, double end_s) {
  std::vector<double> times = {0, end_s};
  for (const auto* level : {&water.upstream_level_m, &water.downstream_level_m}) {
    if (!*level) continue;
    for (const double time_s : (*level)->time_s) {
      if (time_s > 0 && time_s < end_s) times.push_back(time_s);
    }
  }
  const auto at = [&](const std::optional<scene::TimeTable>& level, double time_s) {
    return level ? level->rows_at(time_s) + (level->sine ? std::abs(level->sine->amplitude) : 0) : none;
  };
  double highest = none;
  for (const double time_s : times) {
    const auto [lower, higher] =
        std::minmax({at(water.upstream_level_m, time_s), at(water.downstream_level_m, time_s)});
    if (lower <= crest) highest = std::max(highest, higher);
  }
  return highest;
}

std::string warning(const scene::Scene& scene, double crest, double level) {
  constexpr double seen = 1e-3;  // of the structure
  if (scene.water.crest_pressure != scene::CrestPressure::none) return {};
  if (!std::isfinite(crest) || !(level > crest + seen * scene::structure_size_m(scene.blocks))) return {};
  return fmt::format(
      "the water rose to {:.5g} m, {:.3g} m above the crest; unless both pools are above the crest, the weight of the "
      "water on it is left out; that weight, up to {:.3g} kPa, would hold the structure down; state crest_pressure in "
      "[water] to include it",
      level, level - crest, scene::unit_weight_of_water(scene) * (level - crest) / 1000);
}

}  // namespace

std::string water_on_crest_warning(const expect::Outcome& o) {
  const scene::Scene& scene = o.solid.scene();
  if (scene.fluid != scene::FluidModel::hydrostatic) return {};
  const auto& failures = o.failure.failures();
  const double end_s = failures.empty() ? o.last.time_s : failures.front().time_s;
  const double crest = crest_m(scene);
  return warning(scene, crest, highest_alone_m(scene.water, crest, end_s));
}

std::string water_on_crest_warning(const scene::Scene& scene, double level_m) {
  const double crest = crest_m(scene);
  const auto& down = scene.water.downstream_level_m;
  if (down && down->at(scene.analysis.duration_s) > crest) return {};
  return warning(scene, crest, level_m);
}

}  // namespace blockweir::solid::output
