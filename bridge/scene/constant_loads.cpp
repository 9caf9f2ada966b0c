// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/constant_loads.hpp"

#include "bridge/scene/load_tables.hpp"

namespace blockweir::scene {
namespace {

bool stays(const Scene& scene, const TimeTable& table) {
  return table.constant_until(0) >= scene.analysis.duration_s;
}

bool stays(const Scene& scene, const std::optional<TimeTable>& table) {
  return !table || stays(scene, *table);
}

}  // namespace

bool level_is_constant(const Scene& scene, bool downstream) {
  const auto& level = downstream ? scene.water.downstream_level_m : scene.water.upstream_level_m;
  return still_pools(scene.fluid) && level && stays(scene, level);
}

bool loads_are_constant(const Scene& scene) {
  if (!(scene.fluid == FluidModel::none || still_pools(scene.fluid)) || scene.base_motion) return false;
  bool all = stays(scene, scene.water.upstream_level_m) && stays(scene, scene.water.downstream_level_m);
  each_load_table(scene, [&](const TimeTable& table) { all = all && stays(scene, table); });
  for (const Support& support : scene.supports) {
    all = all && stays(scene, support.displacement_x_m) && stays(scene, support.displacement_y_m);
  }
  return all;
}

}  // namespace blockweir::scene
