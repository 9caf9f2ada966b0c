// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/capacity/situation.hpp"

#include <limits>

#include "bridge/statics/loads.hpp"

namespace blockweir::solid {

Situation::Situation(const scene::Scene& given, const process::FluidMaker& make_fluid)
    : scene(given), level_m(std::numeric_limits<double>::quiet_NaN()) {
  if (scene.fluid == scene::FluidModel::none) return;
  water.emplace(scene, make_fluid);
  const auto& level = scene.water.upstream_level_m;
  level_m = level ? level->at(scene.analysis.duration_s) : water->range().empty_m;
}

limit::Wrenches Situation::dead() {
  const limit::Wrenches weights = statics::weights_of(scene);
  return water ? limit::combined(weights, 1, statics::water_forces(scene, water->at(level_m))) : weights;
}

}  // namespace blockweir::solid
