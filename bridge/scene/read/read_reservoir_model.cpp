// SPDX-License-Identifier: GPL-3.0-or-later
// [fluid.reservoir]: finite elements of water that answers accelerations.
#include <fmt/format.h>

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

/// A far end that would stand within the model.
void check_wall(TableReader& table, Reading& reading, const char* key, const std::optional<double>& wall_m, int side) {
  std::vector<Point> all;
  for (const Block& block : reading.scene.blocks) all.insert(all.end(), block.vertices.begin(), block.vertices.end());
  if (!wall_m || all.empty()) return;
  const geometry::Bounds model = geometry::bounds_of(all);
  const double end_m = side < 0 ? model.low.x() : model.high.x();
  if (side * (*wall_m - end_m) >= 0) return;
  reading.problems.error(table.place(key),
                         fmt::format("{} is {} m, within the model, which ends at {} m", key, *wall_m, end_m),
                         fmt::format("{} {} m", side < 0 ? "at most" : "at least", end_m),
                         "move the wall off the blocks, or leave it out: the reservoir is long then");
}

}  // namespace

/// Water that lets sound through, far faster than anything falls.
void read_compressible(TableReader& table, Reading& reading) {
  Reservoir& r = reading.scene.reservoir;
  table.flag("compressible", r.compressible);
  table.number("sound_speed_m_per_s", r.sound_speed_m_per_s, positive());
  table.number("bottom_reflection", r.bottom_reflection,
               {[](double share) { return share >= 0 && share <= 1; }, "a number from 0 to 1"});
  for (const char* key : {"sound_speed_m_per_s", "bottom_reflection"}) {
    if (r.compressible || !table.has(key)) continue;
    reading.problems.error(table.place(key), fmt::format("{} of water that is not compressible", key),
                           "compressible = true", fmt::format("state it, or leave {} out", key));
  }
  const double fall = std::sqrt(reading.scene.analysis.gravity_m_per_s2 * structure_size_m(reading.scene.blocks));
  if (r.compressible && r.sound_speed_m_per_s <= 2 * fall) {
    reading.problems.error(
        table.place("sound_speed_m_per_s"),
        fmt::format("sound_speed_m_per_s is {}: blocks of this structure fall as fast", r.sound_speed_m_per_s),
        fmt::format("above {:.4g} m/s, twice the speed of a fall by the structure's size", 2 * fall),
        "correct it: sound takes some 1440 m/s in water");
  }
  for (const Block& block : reading.scene.blocks) {
    const double speed = block.initial_velocity_m_per_s.norm();
    if (!r.compressible || r.sound_speed_m_per_s > 2 * speed) continue;
    reading.problems.error(table.place("sound_speed_m_per_s"),
                           fmt::format("sound takes {} m/s in the water, and block \"{}\" begins with {:.4g} m/s",
                                       r.sound_speed_m_per_s, block.name, speed),
                           fmt::format("above {:.4g} m/s, twice the speed of the fastest block", 2 * speed),
                           "correct initial_velocity_m_per_s of the block, or sound_speed_m_per_s: some 1440 m/s");
  }
}

void read_reservoir_model(TableReader& fluid, Reading& reading) {
  const toml::table* section = fluid.table("reservoir");
  if (section == nullptr) return;
  TableReader table(reading.problems, section, "[fluid.reservoir]");
  Reservoir& r = reading.scene.reservoir;
  table.number("upstream_wall_m", r.upstream_wall_m, any_number());
  table.number("downstream_wall_m", r.downstream_wall_m, any_number());
  table.number("element_ratio", r.element_ratio,
               {[](double ratio) { return ratio >= 0.005 && ratio <= 1; }, "a number from 0.005 to 1"});
  table.number("move_tolerance", r.move_tolerance,
               {[](double share) { return share >= 0 && share <= 0.1; }, "a number from 0 to 0.1"});
  table.choice<bool>("surface", r.surface_waves, {{"level", false}, {"waves", true}});
  if (r.surface_waves && reading.scene.analysis.gravity_m_per_s2 == 0) {
    reading.problems.error(table.place("surface"), "surface = \"waves\" without gravity", "gravity_m_per_s2 above 0",
                           "state gravity, or leave surface out");
  }
  read_compressible(table, reading);
  if (reading.scene.fluid != FluidModel::reservoir) {
    reading.problems.error(table.place(), "[fluid.reservoir] beside another model", "model = \"reservoir\" in [fluid]",
                           "leave [fluid.reservoir] out, or set the model");
  }
  check_wall(table, reading, "upstream_wall_m", r.upstream_wall_m, -1);
  check_wall(table, reading, "downstream_wall_m", r.downstream_wall_m, 1);
}

}  // namespace blockweir::scene
