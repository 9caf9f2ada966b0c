// SPDX-License-Identifier: GPL-3.0-or-later
// The water and the model that computes its pressure.
#include <fmt/format.h>

#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

void read_water(Reading& reading) {
  TableReader table(reading.problems, reading.section("water"), "[water]");
  Water& w = reading.scene.water;
  const double duration = reading.scene.analysis.duration_s;
  table.number("density_kg_per_m3", w.density_kg_per_m3, positive());
  table.time_table("upstream_level_m", w.upstream_level_m, duration);
  table.time_table("downstream_level_m", w.downstream_level_m, duration);
  table.choice<Atmosphere>("atmosphere", w.atmosphere,
                           {{"none", Atmosphere::none}, {"wet-faces", Atmosphere::wet_faces}});
  table.number("atmospheric_pressure_pa", w.atmospheric_pressure_pa, not_negative());
  table.choice<NodalRule>("nodal_rule", w.nodal_rule,
                          {{"consistent", NodalRule::consistent}, {"lumped", NodalRule::lumped}});
  table.integer("elements_per_face", w.elements_per_face, 1);
  // The consistent forces of a linear pressure do not depend on their number.
  if (!table.has("elements_per_face") && w.nodal_rule == NodalRule::consistent) w.elements_per_face = 1;
  table.number("open_crack_width_m", w.open_crack_width_m, positive());
  if (bool wets = false; table.flag("wets_ends", wets)) w.wets_ends = wets;
  table.flag("may_overtop", w.may_overtop);
  table.choice<CrestPressure>(
      "crest_pressure", w.crest_pressure,
      {{"none", CrestPressure::none}, {"triangular", CrestPressure::triangular}, {"full", CrestPressure::full}});
  table.choice<ShakenUplift>("uplift_in_shaking", w.uplift_in_shaking,
                             {{"held", ShakenUplift::held}, {"zero-where-open", ShakenUplift::zero_where_open}});
  table.flag("skip_unchanged", w.skip_unchanged);
  if (!table.present()) return;
  reading.scene.fluid = FluidModel::hydrostatic;
  const toml::table* fluid = reading.file["fluid"].as_table();
  const bool elsewhere = fluid != nullptr && (fluid->contains("initial_water_m") || fluid->contains("column") ||
                                              (*fluid)["model"].value_or("") == std::string("external"));
  if (!elsewhere && !table.has("upstream_level_m") && !table.has("downstream_level_m")) {
    reading.problems.error(table.place(), "[water] has no level", "upstream_level_m, downstream_level_m or both",
                           "state a level, or leave [water] out");
  }
  if (reading.scene.analysis.gravity_tilt_deg != 0) {
    reading.problems.error(table.place(), "[water] in a scene whose gravity is tilted", "gravity along the y axis",
                           "set gravity_tilt_deg = 0 in [analysis] and turn the blocks instead");
  }
}

void read_fluid(Reading& reading) {
  const bool water = reading.scene.fluid == FluidModel::hydrostatic;
  if (const toml::array* several = reading.file["fluid"].as_array(); several != nullptr) {
    reading.sections.emplace_back("fluid");
    reading.problems.error(reading.problems.at(several->source()),
                           fmt::format("[[fluid]], a list of {} fluids; each window has one partner, who answers for "
                                       "all water",
                                       several->size()),
                           "one [fluid]", "let one program compute all of the water: model = \"external\"");
    return;
  }
  TableReader table(reading.problems, reading.section("fluid"), "[fluid]");
  FluidModel& model = reading.scene.fluid;
  std::vector<std::pair<const char*, FluidModel>> models;
  for (const FluidEntry& entry : fluid_models) models.emplace_back(entry.key, entry.model);
  table.choice<FluidModel>("model", model, models);
  if (model != FluidModel::none && !water && !fluid_entry(model).yours) {
    reading.problems.error(table.place("model"), "a fluid, but no [water]", "[water] with a level",
                           "add [water], or set model = \"none\"");
  }
  read_reservoir_model(table, reading);
  read_column(table, reading);
  read_external(table, reading);
  read_openfoam(table, reading);
}

}  // namespace blockweir::scene
