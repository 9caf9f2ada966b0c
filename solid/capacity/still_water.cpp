// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/capacity/still_water.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "bridge/scene/load_tables.hpp"

namespace blockweir::solid {
namespace {

/// The same scene with a reservoir that rises by a metre a second from empty to full.
scene::Scene filled(scene::Scene scene, const limit::LevelRange& range) {
  if (scene.analysis.gravity_tilt_deg != 0) {
    throw std::invalid_argument(
        scene.fluid == scene::FluidModel::none
            ? "gravity_tilt_deg of [analysis] is not 0, in a scene without [water]; expected gravity along the y axis: "
              "this fills a reservoir; ask blockweir safety how the blocks stand, or turn them instead"
            : "gravity_tilt_deg of [analysis] is not 0; expected gravity along the y axis where there is water; turn "
              "the blocks instead");
  }
  if (scene.fluid == scene::FluidModel::column) {
    throw std::invalid_argument(
        "model = \"column\" in [fluid]; expected a reservoir with a level; state [water] without that model");
  }
  if (scene::fluid_entry(scene.fluid).yours && !scene.water.upstream_level_m) {
    throw std::invalid_argument(
        "model = \"external\" in [fluid]; expected water whose pressures are known without a run; add a level to "
        "[water], "
        "which still water then has here, or leave [fluid] out");
  }
  scene::Water& water = scene.water;
  if (water.downstream_level_m && !water.upstream_level_m) {
    throw std::invalid_argument(fmt::format(
        "[water] has a downstream_level_m alone; expected an upstream_level_m, of the pool on the left, too: level and "
        "the factor of safety take both; for a side that is dry state upstream_level_m = {:.6g}, or mirror the scene",
        range.empty_m));
  }
  if (scene.fluid == scene::FluidModel::none && water.nodal_rule == scene::NodalRule::consistent) {
    water.elements_per_face = 1;
  }
  const bool answers = water.is_shaken() && water.added_water == scene::AddedWater::reservoir;
  scene.fluid = answers ? scene::FluidModel::reservoir : scene::FluidModel::hydrostatic;
  if (water.downstream_level_m) {
    water.downstream_level_m = scene::TimeTable::constant(water.downstream_level_m->at(scene.analysis.duration_s));
  }
  scene::TimeTable rises{.time_s = {0, range.full_m - range.empty_m}, .value = {range.empty_m, range.full_m}};
  const double stated_m = water.upstream_level_m ? water.upstream_level_m->at(scene.analysis.duration_s) : range.full_m;
  if (stated_m > range.full_m) {  // a factor is asked for at any level, the level of failure only up to the full one
    rises.time_s.push_back(stated_m - range.empty_m);
    rises.value.push_back(stated_m);
  }
  water.upstream_level_m = std::move(rises);
  // Time is the level: a crack whose length follows the loads is to have those of the run's end.
  const double end_s = scene.analysis.duration_s;
  scene::each_load_table(scene,
                         [end_s](scene::TimeTable& table) { table = scene::TimeTable::constant(table.at(end_s)); });
  scene.joint_flow.kind = scene::FlowKind::steady;
  scene.output.reservoir = false;
  return scene;
}

}  // namespace

StillWater::StillWater(const scene::Scene& scene, const process::FluidMaker& make)
    : range_(limit::level_range(scene)), scene_(filled(scene, range_)), fluid_(make(scene_, {})) {}

const wire::Load& StillWater::at(double level_m, const wire::Motion& motion) {
  fluid_->advance(motion, level_m - range_.empty_m, load_);
  return load_;
}

const wire::Load& StillWater::at(double level_m) {
  wire::Motion drawn;
  drawn.displacement.assign(scene_.blocks.size(), {});
  drawn.velocity.assign(scene_.blocks.size(), {});
  return at(level_m, drawn);
}

}  // namespace blockweir::solid
