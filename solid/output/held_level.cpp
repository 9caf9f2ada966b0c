// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/held_level.hpp"

#include <fmt/format.h>

#include "bridge/scene/structure_size.hpp"

namespace blockweir::solid::output {

std::string held_level_warning(const expect::Outcome& o) {
  constexpr double seen_ratio = 0.05;  // of the structure: what moves farther leaves room that water has to fill
  const scene::Scene& scene = o.solid.scene();
  if (scene.fluid != scene::FluidModel::openfoam) return {};
  if (scene.openfoam.level_control != scene::LevelControl::table) return {};
  if (!scene.water.upstream_level_m && !scene.water.downstream_level_m) return {};
  const double farthest_m = o.failure.farthest_failed_m();
  if (!o.failure.failed() || farthest_m <= seen_ratio * scene::structure_size_m(scene.blocks)) return {};
  return fmt::format(
      "the water kept its level while blocks that failed moved up to {:.3g} m: level_control = \"table\" in [fluid] "
      "sets it in every window, which adds water where the structure held it before; the failure is right, the fall "
      "and the flow after it are not; for these state level_control = \"free\", by which the pools run out from their "
      "levels at time 0, or \"inflow\" where a level rises",
      farthest_m);
}

}  // namespace blockweir::solid::output
