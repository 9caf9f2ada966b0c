// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/additional_water_loads.hpp"

#include "bridge/statics/loads.hpp"
#include "solid/capacity/still_water.hpp"

namespace blockweir::solid {
namespace {

statics::Wrenches open_water(const scene::Scene& scene, const process::FluidMaker& make_fluid, double level_m) {
  StillWater water(scene, make_fluid);
  const wire::Load& load = water.at(level_m);
  return statics::water_forces(scene, load, 0, load.cracks_from);
}

}  // namespace

std::string added_water_name(const scene::Scene& scene) {
  return std::string("added water (") + scene::name_of(scene.water.added_water) + ")";
}

std::vector<WaterPart> additional_water_loads(const scene::Scene& scene, const process::FluidMaker& make_fluid,
                                              double level_m) {
  std::vector<WaterPart> parts;
  if (!scene.water.ice && !scene.water.is_shaken()) return parts;
  const statics::Wrenches all = open_water(scene, make_fluid, level_m);
  const auto add = [&](const std::string& name, const scene::Scene& without) {
    parts.push_back({name, statics::combined(all, -1, open_water(without, make_fluid, level_m))});
  };
  scene::Scene without = scene;
  without.water.ice.reset();
  if (scene.water.ice) add("ice", without);
  without = scene;
  without.water.leave_out_earthquake();
  if (scene.water.is_shaken()) add(added_water_name(scene), without);
  return parts;
}

}  // namespace blockweir::solid
