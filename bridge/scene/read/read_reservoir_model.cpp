// SPDX-License-Identifier: GPL-3.0-or-later
// [fluid.reservoir]: finite elements of water that answers accelerations.
#include <fmt/format.h>

#include <toml++/toml.h>

#include <algorithm>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/read/reading.hpp"

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
  if (reading.scene.fluid != FluidModel::reservoir) {
    reading.problems.error(table.place(), "[fluid.reservoir] beside another model", "model = \"reservoir\" in [fluid]",
                           "leave [fluid.reservoir] out, or set the model");
  }
  check_wall(table, reading, "upstream_wall_m", r.upstream_wall_m, -1);
  check_wall(table, reading, "downstream_wall_m", r.downstream_wall_m, 1);
}

}  // namespace blockweir::scene
