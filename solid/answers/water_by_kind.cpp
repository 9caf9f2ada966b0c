// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/water_by_kind.hpp"

#include "solid/answers/additional_water_loads.hpp"
#include "solid/capacity/still_water.hpp"

namespace blockweir::solid {
namespace {

using nlohmann::json;

void add_kind(const scene::Scene& scene, const wire::Load& load, std::size_t first, std::size_t last,
              const std::string& name, json& kinds) {
  json panels = json::array();
  for (std::size_t i = first; i < last; ++i) {
    const scene::Block& block = scene.blocks[load.block[i]];
    const scene::Point& a = block.vertices[load.edge[i]];
    const scene::Point span = block.vertices[(load.edge[i] + 1) % block.vertices.size()] - a;
    const scene::Point from = a + load.s_from[i] * span;
    const scene::Point to = a + load.s_to[i] * span;
    panels.push_back(
        {from.x(), from.y(), to.x(), to.y(), load.pressure_from_pa[i], load.pressure_to_pa[i], load.block[i]});
  }
  if (!panels.empty()) kinds.push_back({{"name", name}, {"panels", std::move(panels)}});
}

std::size_t open_panels(const scene::Scene& scene, const process::FluidMaker& make_fluid, double level_m) {
  StillWater water(scene, make_fluid);
  return water.at(level_m).cracks_from;
}

}  // namespace

json water_by_kind(const scene::Scene& scene, const process::FluidMaker& make_fluid, double level_m) {
  StillWater water(scene, make_fluid);
  const wire::Load& load = water.at(level_m);
  scene::Scene without = scene;  // ice and then the earthquake's water are added behind the pressures at rest
  without.water.leave_out_earthquake();
  const std::size_t with_ice = scene.water.is_shaken() ? open_panels(without, make_fluid, level_m) : load.cracks_from;
  without.water.ice.reset();
  const std::size_t at_rest = scene.water.ice ? open_panels(without, make_fluid, level_m) : with_ice;
  json kinds = json::array();
  add_kind(scene, load, 0, at_rest, "open water", kinds);
  add_kind(scene, load, at_rest, with_ice, "ice", kinds);
  add_kind(scene, load, with_ice, load.cracks_from, added_water_name(scene), kinds);
  add_kind(scene, load, load.cracks_from, load.block.size(), "water in joints", kinds);
  return kinds;
}

}  // namespace blockweir::solid
