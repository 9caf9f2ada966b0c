// SPDX-License-Identifier: GPL-3.0-or-later
// The water and the model that computes its pressure.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

/// Lowest and highest value that a table takes from time 0 to `duration_s`.
std::pair<double, double> extremes(const TimeTable& table, double duration_s) {
  auto [low, high] = std::minmax({table.rows_at(0), table.rows_at(duration_s)});
  for (std::size_t i = 0; i < table.time_s.size(); ++i) {
    if (table.time_s[i] < 0 || table.time_s[i] > duration_s) continue;
    low = std::min(low, table.value[i]);
    high = std::max(high, table.value[i]);
  }
  if (table.sine) low -= std::abs(table.sine->amplitude), high += std::abs(table.sine->amplitude);
  return {low, high};
}

/// Crest: the highest moving vertex, or the highest of all if nothing moves. Bottom: the lowest of all.
struct Heights {
  double bottom_m;
  double crest_m;
};

std::optional<Heights> heights(const std::vector<Block>& blocks) {
  std::vector<Point> all;
  std::vector<Point> movable;
  for (const Block& block : blocks) {
    all.insert(all.end(), block.vertices.begin(), block.vertices.end());
    if (!block.fixed) movable.insert(movable.end(), block.vertices.begin(), block.vertices.end());
  }
  if (all.empty()) return std::nullopt;
  return Heights{geometry::bounds_of(all).low.y(), geometry::bounds_of(movable.empty() ? all : movable).high.y()};
}

void check_level(TableReader& table, Reading& reading, const char* key, const std::optional<TimeTable>& level) {
  const bool sound =
      reading.blocks.complete() && std::none_of(reading.scene.blocks.begin(), reading.scene.blocks.end(),
                                                [](const Block& block) { return block.vertices.empty(); });
  const auto model = heights(reading.scene.blocks);
  if (!level || !model || !sound) return;
  const auto [low, high] = extremes(*level, reading.scene.analysis.duration_s);
  const double round_off_m = 1e-9 * (model->crest_m - model->bottom_m);  // of a ramp up to the crest
  if (high > model->crest_m + round_off_m && !reading.scene.water.may_overtop) {
    reading.problems.error(
        table.place(key),
        fmt::format("{} reaches {:.6g} m, above the structure's highest vertex at {:.6g} m", key, high, model->crest_m),
        "a level within the structure", "lower the level, or set may_overtop = true in [water] if that is meant");
  }
  if (low < model->bottom_m - round_off_m) {
    reading.problems.error(
        table.place(key),
        fmt::format("{} falls to {:.6g} m, below the model's lowest vertex at {:.6g} m", key, low, model->bottom_m),
        "a level within the model", "raise the level, or leave it out where there is no water");
  }
}

}  // namespace

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
  check_level(table, reading, "upstream_level_m", w.upstream_level_m);
  check_level(table, reading, "downstream_level_m", w.downstream_level_m);
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
