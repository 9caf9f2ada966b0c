// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/water_on_crest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bridge/scene/crest.hpp"
#include "bridge/scene/hydrostatics.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::solid::output {
namespace {

constexpr double none = -std::numeric_limits<double>::infinity();

/// A level above the crest, and its height above the crest or the other pool.
struct Nappe {
  double level_m = none;
  double head_m = none;
};
/// The highest nappe from time 0 to `end_s`.
Nappe highest_nappe(const scene::Water& water, double crest, double end_s) {
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
  Nappe highest;
  for (const double time_s : times) {
    const auto [lower, higher] =
        std::minmax({at(water.upstream_level_m, time_s), at(water.downstream_level_m, time_s)});
    const double head = higher - std::max(lower, crest);
    if (head > highest.head_m) highest = {higher, head};
  }
  return highest;
}

std::string warning(const scene::Scene& scene, const scene::Crest& crest, const Nappe& nappe) {
  constexpr double seen = 1e-3;  // of the structure
  if (!std::isfinite(crest.height_m) || !(nappe.head_m > seen * scene::structure_size_m(scene.blocks))) return {};
  const std::string rose =
      fmt::format("the water rose to {:.5g} m, {:.3g} m above the ", nappe.level_m, nappe.level_m - crest.height_m);
  if (crest.edges.empty()) {
    return rose +
           "structure's highest point, which is on no level crest: faces up to that point bear the whole head of "
           "the pool that stands before them, those that slope gently, too, and crest_pressure has no effect; "
           "where that water flows, it presses less; draw the crest level to have crest_pressure decide";
  }
  if (scene.water.crest_pressure != scene::CrestPressure::none) return {};
  return rose +
         fmt::format(
             "crest; unless both pools are above the crest, the weight of the water on it is left out, and where "
             "they are, that of the water above the lower pool; that weight, up to {:.3g} kPa, would hold the "
             "structure down; state crest_pressure in [water] to include it",
             scene::unit_weight_of_water(scene) * nappe.head_m / 1000);
}

}  // namespace

std::string water_on_crest_warning(const expect::Outcome& o) {
  const scene::Scene& scene = o.solid.scene();
  if (!scene::still_pools(scene.fluid)) return {};
  const auto& failures = o.failure.failures();
  const double end_s = failures.empty() ? o.last.time_s : failures.front().time_s;
  const scene::Crest crest = scene::crest_of(scene.blocks);
  return warning(scene, crest, highest_nappe(scene.water, crest.height_m, end_s));
}

std::string water_on_crest_warning(const scene::Scene& scene, double level_m) {
  const scene::Crest crest = scene::crest_of(scene.blocks);
  const auto& down = scene.water.downstream_level_m;
  const double other = down ? std::max(crest.height_m, down->at(scene.analysis.duration_s)) : crest.height_m;
  return warning(scene, crest, {level_m, level_m - other});
}

}  // namespace blockweir::solid::output
