// SPDX-License-Identifier: GPL-3.0-or-later
// Loads on a dam beside its weight and still water: silt, ice, a pseudo-static earthquake.
#include <fmt/format.h>

#include <cmath>

#include "bridge/scene/at.hpp"
#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/ground_ends.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/upstream_faces.hpp"

namespace blockweir::scene {
namespace {

/// Reports loads that act through the reservoir, if the scene has no still water.
void require_still_water(TableReader& table, Reading& reading) {
  const bool stated = reading.file["water"]["upstream_level_m"].node() != nullptr;  // a wrong one is told of there
  if (still_pools(reading.scene.fluid) && stated) return;
  const FluidModel model = reading.scene.fluid;
  const bool other = model == FluidModel::openfoam || model == FluidModel::external;
  reading.problems.error(table.place(),
                         other ? fmt::format("{} with model = \"{}\"", table.name(), fluid_entry(model).key)
                               : fmt::format("{} without a reservoir", table.name()),
                         "[water] with upstream_level_m, and model = \"hydrostatic\"",
                         other ? "leave model out, or leave this table out" : "add the level, or leave this out");
}

TimeTable constant(double value) {
  return TimeTable::constant(value);
}

}  // namespace

/// Is it a part of the cut by which the model ends in ground that goes on? There is more ground behind it, no silt.
bool is_cut(const UpstreamFace& face, const Scene& scene) {
  const auto end = find_ground_ends(scene).left;
  if (!end) return false;
  const Point& corner = scene.blocks[at(end->block)].vertices[at(end->vertex)];
  const double near_m = 1e-6 * bounds_of(scene).size();
  return std::abs(face.top_m.x() - corner.x()) <= near_m && std::abs(face.bottom_m.x() - corner.x()) <= near_m &&
         face.top_m.y() <= corner.y() + near_m;
}

/// On a face with the outward normal n at the depth d: K gamma' d |n_x| downstream, gamma' d n_y down where it looks
/// up.
void read_silt(Reading& reading) {
  TableReader table(reading.problems, reading.section("silt"), "[silt]");
  if (!table.present()) return;
  double level = 0;
  double density = 0;
  double coefficient = 0;
  // Each is looked at, so that all that is wrong is told at once.
  const bool has_level = table.number("level_m", level, any_number(), true);
  const bool has_density = table.number("submerged_density_kg_per_m3", density, positive(), true);
  const bool has_coefficient = table.number("pressure_coefficient", coefficient,
                                            {[](double k) { return k >= 0 && k <= 1; }, "a number from 0 to 1"}, true);
  if (!has_level || !has_density || !has_coefficient || reading.problems.count() > 0) return;
  std::vector<UpstreamFace> faces = upstream_faces(reading.scene, level);
  std::erase_if(faces, [&](const UpstreamFace& face) { return is_cut(face, reading.scene); });
  const std::vector<UpstreamFloor> floors = upstream_floors(reading.scene, level);
  if (faces.empty() && floors.empty()) {
    reading.problems.error(table.place("level_m"),
                           fmt::format("level_m in [silt] is {} m, below every upstream face that can move", level),
                           "a level above the structure's foot", "raise it, or leave [silt] out");
  }
  const double weight = density * reading.scene.analysis.gravity_m_per_s2;
  for (const UpstreamFace& face : faces) {
    const Point down = (face.bottom_m - face.top_m).normalized();
    const auto at_height = [&](double y) {
      const double vertical = weight * (level - y);
      return std::array{constant(-coefficient * vertical * down.y()), constant(std::min(0.0, vertical * down.x()))};
    };
    reading.scene.line_loads.push_back({.block = face.block,
                                        .from_m = face.top_m,
                                        .to_m = face.bottom_m,
                                        .force_from_n_per_m2 = at_height(face.top_m.y()),
                                        .force_to_n_per_m2 = at_height(face.bottom_m.y()),
                                        .origin = LoadOrigin::silt});
  }
  for (const UpstreamFloor& floor : floors) {
    const std::array down{constant(0), constant(-weight * (level - floor.left_m.y()))};
    reading.scene.line_loads.push_back({.block = floor.block,
                                        .from_m = floor.left_m,
                                        .to_m = floor.right_m,
                                        .force_from_n_per_m2 = down,
                                        .force_to_n_per_m2 = down,
                                        .origin = LoadOrigin::silt});
  }
}

void read_ice(Reading& reading) {
  TableReader table(reading.problems, reading.section("ice"), "[ice]");
  if (!table.present()) return;
  Ice ice;
  table.number("thrust_n_per_m", ice.thrust_n_per_m, not_negative(), true);
  table.number("thickness_m", ice.thickness_m, positive(), true);
  require_still_water(table, reading);
  if (ice.thrust_n_per_m > 0) reading.scene.water.ice = ice;  // a load case may take the ice away
}

void read_earthquake(Reading& reading) {
  TableReader table(reading.problems, reading.section("earthquake"), "[earthquake]");
  if (!table.present()) return;
  enum class Added { westergaard, reservoir, none };
  const bool answers = reading.scene.fluid == FluidModel::reservoir;
  double horizontal = 0;
  double vertical = 0;
  Added added = answers ? Added::reservoir : Added::westergaard;
  const Range below_one{[](double k) { return std::abs(k) < 1; }, "a share of gravity, between -1 and 1"};
  table.number("horizontal_coefficient", horizontal, below_one, true);
  table.number("vertical_coefficient", vertical, below_one);
  table.choice<Added>("added_water_pressure", added,
                      {{"westergaard", Added::westergaard}, {"reservoir", Added::reservoir}, {"none", Added::none}});
  if (added == Added::reservoir && !answers) {
    reading.problems.error(table.place("added_water_pressure"),
                           "added_water_pressure = \"reservoir\" beside still water",
                           "model = \"reservoir\" in [fluid]", "set the model, or take \"westergaard\"");
  }
  BodyLoad inertia{.origin = LoadOrigin::earthquake};
  for (std::size_t b = 0; b < reading.scene.blocks.size(); ++b) {
    if (!reading.scene.blocks[b].fixed) inertia.blocks.push_back(static_cast<int>(b));
  }
  const double gravity = reading.scene.analysis.gravity_m_per_s2;
  inertia.value = {constant(horizontal * gravity), constant(vertical * gravity)};
  reading.scene.body_loads.push_back(std::move(inertia));
  const bool reservoir = reading.scene.water.upstream_level_m.has_value();
  if (added == Added::none || (!reservoir && !table.has("added_water_pressure"))) return;
  require_still_water(table, reading);
  Water& water = reading.scene.water;
  water.earthquake_coefficient = horizontal;
  if (added != Added::reservoir) return;
  water.added_water = AddedWater::reservoir;
  water.earthquake_vertical_coefficient = vertical;
}

}  // namespace blockweir::scene
