// SPDX-License-Identifier: GPL-3.0-or-later
// What holds and pushes the blocks: supports, point loads, pressures on faces.
#include <fmt/format.h>

#include "bridge/scene/outline.hpp"
#include "bridge/scene/sections.hpp"

namespace blockweir::scene {
namespace {

double tolerance_m(const Block& block) {
  return 1e-6 * bounds_of(block.vertices).size();
}

/// Reads block and point_m; the point must be on the block.
void read_point_on_block(TableReader& table, Reading& reading, int& index, Point& point) {
  index = table.reference("block", reading.blocks);
  if (!table.point("point_m", point, true)) return;
  const Block* block = reading.sound_block(index);
  if (block == nullptr || holds_point(block->vertices, point, tolerance_m(*block))) return;
  reading.problems.error(
      table.place("point_m"),
      fmt::format("point_m ({}, {}) in {} is outside block \"{}\"", point.x(), point.y(), table.name(), block->name),
      "a point in the block or on its outline", "move the point or name the block that it is on");
}

void reject(TableReader& table, Problems& problems, const char* found, const char* expected, const char* remedy) {
  problems.error(table.place(), fmt::format("{} {}", table.name(), found), expected, remedy);
}

void read_force(TableReader& table, Reading& reading, PointLoad& load) {
  const double duration = reading.scene.analysis.duration_s;
  Point force = Point::Zero();
  std::optional<TimeTable> x;
  std::optional<TimeTable> y;
  table.point("force_n_per_m", force);
  table.time_table("force_x_n_per_m", x, duration);
  table.time_table("force_y_n_per_m", y, duration);
  const bool both = table.has("force_n_per_m");
  const bool parts = table.has("force_x_n_per_m") || table.has("force_y_n_per_m");
  if (both == parts) {
    reject(table, reading.problems, both ? "states its force twice" : "has no force",
           "force_n_per_m = [x, y], or force_x_n_per_m and force_y_n_per_m", "keep one of the two ways");
  }
  load.force_x_n_per_m = x.value_or(TimeTable::constant(force.x()));
  load.force_y_n_per_m = y.value_or(TimeTable::constant(force.y()));
}

void read_face(TableReader& table, Reading& reading, FacePressure& load) {
  load.block = table.reference("block", reading.blocks);
  const bool from = table.point("from_m", load.from_m, true);
  const bool to = table.point("to_m", load.to_m, true);
  const Block* block = reading.sound_block(load.block);
  if (!from || !to || block == nullptr) return;
  const double tolerance = tolerance_m(*block);
  if ((load.to_m - load.from_m).norm() <= tolerance) {
    reject(table, reading.problems, "begins and ends at the same point", "two points of one edge", "move one of them");
  } else if (!on_one_edge(block->vertices, load.from_m, load.to_m, tolerance)) {
    reading.problems.error(
        table.place("from_m"),
        fmt::format("{} from ({}, {}) to ({}, {}) does not lie on one edge of block \"{}\"", table.name(),
                    load.from_m.x(), load.from_m.y(), load.to_m.x(), load.to_m.y(), block->name),
        "two points of one edge", "use one [[face_pressure]] for each edge");
  }
}

}  // namespace

void read_supports(Reading& reading) {
  const double duration = reading.scene.analysis.duration_s;
  reading.each("support", [&](TableReader& table) {
    Support support;
    read_point_on_block(table, reading, support.block, support.point_m);
    table.time_table("displacement_x_m", support.displacement_x_m, duration);
    table.time_table("displacement_y_m", support.displacement_y_m, duration);
    if (!table.has("displacement_x_m") && !table.has("displacement_y_m")) {
      reject(table, reading.problems, "holds nothing", "displacement_x_m, displacement_y_m or both",
             "write displacement_y_m = 0 to hold the point in y");
    }
    reading.scene.supports.push_back(std::move(support));
  });
}

void read_point_loads(Reading& reading) {
  reading.each("point_load", [&](TableReader& table) {
    PointLoad load;
    read_point_on_block(table, reading, load.block, load.point_m);
    read_force(table, reading, load);
    reading.scene.point_loads.push_back(std::move(load));
  });
}

void read_face_pressures(Reading& reading) {
  const double duration = reading.scene.analysis.duration_s;
  reading.each("face_pressure", [&](TableReader& table) {
    FacePressure load;
    read_face(table, reading, load);
    std::optional<TimeTable> uniform;
    std::optional<TimeTable> from;
    std::optional<TimeTable> to;
    table.time_table("pressure_pa", uniform, duration);
    table.time_table("pressure_from_pa", from, duration);
    table.time_table("pressure_to_pa", to, duration);
    const int ends = table.has("pressure_from_pa") + table.has("pressure_to_pa");
    if (table.has("pressure_pa") ? ends != 0 : ends != 2) {
      reject(table, reading.problems, "does not state one pressure",
             "pressure_pa, or both pressure_from_pa and pressure_to_pa", "keep one of the two ways");
    }
    load.pressure_from_pa = from.value_or(uniform.value_or(TimeTable::constant(0)));
    load.pressure_to_pa = to.value_or(uniform.value_or(TimeTable::constant(0)));
    reading.scene.face_pressures.push_back(std::move(load));
  });
}

}  // namespace blockweir::scene
