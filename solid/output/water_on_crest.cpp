// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/water_on_crest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/hydrostatics.hpp"

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

/// From time 0 to `end_s`.
double highest_m(const std::optional<scene::TimeTable>& level, double end_s) {
  if (!level) return none;
  double highest = std::max(level->rows_at(0), level->rows_at(end_s));
  for (std::size_t row = 0; row < level->time_s.size(); ++row) {
    if (level->time_s[row] >= 0 && level->time_s[row] <= end_s) highest = std::max(highest, level->value[row]);
  }
  return highest + (level->sine ? std::abs(level->sine->amplitude) : 0);
}

}  // namespace

std::string water_on_crest_warning(const expect::Outcome& o) {
  constexpr double seen = 1e-3;  // of the structure
  const scene::Scene& scene = o.solid.scene();
  if (scene.fluid != scene::FluidModel::hydrostatic) return {};
  if (scene.water.crest_pressure != scene::CrestPressure::none) return {};
  const auto& failures = o.failure.failures();
  const double end_s = failures.empty() ? o.last.time_s : failures.front().time_s;
  const double level =
      std::max(highest_m(scene.water.upstream_level_m, end_s), highest_m(scene.water.downstream_level_m, end_s));
  const double crest = crest_m(scene);
  if (!std::isfinite(crest) || !(level > crest + seen * 2 * o.solid.size_m())) return {};
  return fmt::format(
      "a level of {:.5g} m, {:.3g} m above the crest, has acted: the water on the crest is left out unless both pools "
      "are above it; its weight, up to {:.3g} kPa, would hold the structure down; state crest_pressure in [water], or "
      "know that it is missing",
      level, level - crest, scene::unit_weight_of_water(scene) * (level - crest) / 1000);
}

}  // namespace blockweir::solid::output
