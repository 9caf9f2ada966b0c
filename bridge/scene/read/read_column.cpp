// SPDX-License-Identifier: GPL-3.0-or-later
// [fluid.column]: the pipe of water that measures schedules.
#include <fmt/format.h>

#include <toml++/toml.h>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

/// Index of the edge that contains `p`; -1: none.
int edge_at(const std::vector<Point>& outline, const Point& p) {
  const double tolerance_m = 1e-6 * geometry::bounds_of(outline).size();
  for (std::size_t e = 0; e < outline.size(); ++e) {
    if (geometry::distance_to_segment(p, outline[e], outline[(e + 1) % outline.size()]) <= tolerance_m) {
      return static_cast<int>(e);
    }
  }
  return -1;
}

}  // namespace

void read_column(TableReader& fluid, Reading& reading) {
  const bool meant = reading.scene.fluid == FluidModel::column;
  const toml::table* section = fluid.table("column");
  if (section == nullptr) {
    if (meant && !fluid.has("column")) {
      reading.problems.error(fluid.place("model"), "model = \"column\" without [fluid.column]",
                             "[fluid.column] with block, at_m and length_m", "say which edge the column stands on");
    }
    return;
  }
  TableReader table(reading.problems, section, "[fluid.column]");
  Column& c = reading.scene.column;
  Point at;
  c.block = table.reference("block", reading.blocks);
  const bool placed = table.point("at_m", at, true);
  table.number("length_m", c.length_m, positive(), true);
  table.number("head_m", c.head_m, not_negative());
  table.number("rise_ratio", c.rise_ratio, not_negative());
  table.number("cushion_pa_per_m", c.cushion_pa_per_m, positive());
  table.integer("steps_per_window", c.steps_per_window, 1);
  if (!meant) {
    reading.problems.error(table.place(), "[fluid.column] beside another model", "model = \"column\" in [fluid]",
                           "leave [fluid.column] out, or set the model");
  }
  for (const auto* level : {&reading.scene.water.upstream_level_m, &reading.scene.water.downstream_level_m}) {
    if (!meant || !*level) continue;
    reading.problems.error(table.place(), "a level in [water], but a column has no pool", "head_m in [fluid.column]",
                           "leave the level out");
  }
  const Block* block = reading.sound_block(c.block);
  if (block == nullptr || !placed) return;
  c.edge = edge_at(block->vertices, at);
  if (c.edge >= 0) return;
  reading.problems.error(table.place("at_m"),
                         fmt::format("({}, {}) is not on the outline of block \"{}\"", at.x(), at.y(), block->name),
                         "a point on the edge that the water presses on", "move the point to the edge");
}

}  // namespace blockweir::scene
