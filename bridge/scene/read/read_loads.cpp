// SPDX-License-Identifier: GPL-3.0-or-later
// What holds and pushes the blocks: supports, point and line loads, pressures on faces, body loads.
#include <fmt/format.h>

#include <cmath>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/read/check_sampling.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

double tolerance_m(const Block& block) {
  return 1e-6 * geometry::bounds_of(block.vertices).size();
}

/// Reports what would hold or push a fixed block.
void require_movable(TableReader& table, Reading& reading, const Place& place, int index) {
  const Block* block = reading.sound_block(index);
  if (block == nullptr || !block->fixed) return;
  reading.problems.error(place, fmt::format("{} has no effect: block \"{}\" is fixed", table.name(), block->name),
                         "a block that can move", "leave it out, or name the block that it is to act on");
}

/// Reads block and point_m; the point must be on the block.
void read_point_on_block(TableReader& table, Reading& reading, int& index, Point& point) {
  index = table.reference("block", reading.blocks);
  require_movable(table, reading, table.place("block"), index);
  if (!table.point("point_m", point, true)) return;
  const Block* block = reading.sound_block(index);
  if (block == nullptr || geometry::holds_point(block->vertices, point, tolerance_m(*block))) return;
  reading.problems.error(
      table.place("point_m"),
      fmt::format("point_m ({}, {}) in {} is outside block \"{}\"", point.x(), point.y(), table.name(), block->name),
      "a point in the block or on its outline", "move the point or name the block that it is on");
}

enum class Course { load, displacement };

/// A quantity over time, which the run is to see in its steps: in a dynamic analysis they take up loads' means.
bool read_course(TableReader& table, const char* key, std::optional<TimeTable>& into, Reading& reading,
                 Course course = Course::load) {
  const Analysis& analysis = reading.scene.analysis;
  if (!table.time_table(key, into, analysis.duration_s)) return false;
  if (analysis.kind == AnalysisKind::at_rest) return true;
  const bool means = course == Course::load && analysis.kind == AnalysisKind::dynamic;
  check_sampling(fmt::format("{} in {}", key, table.name()), table.place(key), *into,
                 {"[analysis] step_s", analysis.step_s, analysis.duration_s, means}, reading.problems);
  return true;
}

void reject(TableReader& table, Problems& problems, const char* found, const char* expected, const char* remedy) {
  problems.error(table.place(), fmt::format("{} {}", table.name(), found), expected, remedy);
}

void read_force(TableReader& table, Reading& reading, PointLoad& load) {
  Point force = Point::Zero();
  std::optional<TimeTable> x;
  std::optional<TimeTable> y;
  table.vector("force_n_per_m", force);
  read_course(table, "force_x_n_per_m", x, reading);
  read_course(table, "force_y_n_per_m", y, reading);
  const bool both = table.has("force_n_per_m");
  const bool parts = table.has("force_x_n_per_m") || table.has("force_y_n_per_m");
  if (both == parts) {
    reject(table, reading.problems, both ? "states its force twice" : "has no force",
           "force_n_per_m = [x, y], or force_x_n_per_m and force_y_n_per_m", "keep one of the two ways");
  }
  load.force_x_n_per_m = x.value_or(TimeTable::constant(force.x()));
  load.force_y_n_per_m = y.value_or(TimeTable::constant(force.y()));
}

/// Reads block, from_m and to_m, two points of one edge.
template <class Load>
void read_face(TableReader& table, Reading& reading, Load& load) {
  load.block = table.reference("block", reading.blocks);
  require_movable(table, reading, table.place("block"), load.block);
  const bool from = table.point("from_m", load.from_m, true);
  const bool to = table.point("to_m", load.to_m, true);
  const Block* block = reading.sound_block(load.block);
  if (!from || !to || block == nullptr) return;
  const double tolerance = tolerance_m(*block);
  if ((load.to_m - load.from_m).norm() <= tolerance) {
    reject(table, reading.problems, "begins and ends at the same point", "two points of one edge", "move one of them");
  } else if (!geometry::on_one_edge(block->vertices, load.from_m, load.to_m, tolerance)) {
    reading.problems.error(
        table.place("from_m"),
        fmt::format("{} from ({}, {}) to ({}, {}) does not lie on one edge of block \"{}\"", table.name(),
                    load.from_m.x(), load.from_m.y(), load.to_m.x(), load.to_m.y(), block->name),
        "two points of one edge", "state a load for each edge");
  }
}

/// A component of a line load: uniform, or its values at both ends. False when it is stated in half or twice.
bool read_ends(TableReader& table, Reading& reading, const char* uniform_key, const char* from_key, const char* to_key,
               TimeTable& at_from, TimeTable& at_to) {
  std::optional<TimeTable> uniform;
  std::optional<TimeTable> from;
  std::optional<TimeTable> to;
  read_course(table, uniform_key, uniform, reading);
  read_course(table, from_key, from, reading);
  read_course(table, to_key, to, reading);
  at_from = from.value_or(uniform.value_or(TimeTable::constant(0)));
  at_to = to.value_or(uniform.value_or(TimeTable::constant(0)));
  return table.has(from_key) == table.has(to_key) && !(table.has(uniform_key) && table.has(from_key));
}

/// The blocks named, or all that can move.
std::vector<int> read_loaded_blocks(TableReader& table, Reading& reading) {
  std::vector<int> blocks;
  std::vector<std::string> words;
  if (!table.texts_if_any("blocks", words)) {
    for (std::size_t b = 0; b < reading.scene.blocks.size(); ++b) {
      if (!reading.scene.blocks[b].fixed) blocks.push_back(static_cast<int>(b));
    }
    if (blocks.empty() && reading.blocks.complete() && !reading.scene.blocks.empty()) {
      reject(table, reading.problems, "has no effect: no block can move", "a block that is not fixed",
             "leave it out, or free the block that it is to act on");
    }
    return blocks;
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    blocks.push_back(reading.blocks.find(words[i]));
    require_movable(table, reading, table.place("blocks", i), blocks.back());
    if (blocks.back() >= 0 || !reading.blocks.complete()) continue;
    reading.problems.error(table.place("blocks", i),
                           fmt::format("blocks in {} names no block: \"{}\"", table.name(), words[i]),
                           one_of(reading.blocks.list()), did_you_mean(words[i], reading.blocks.list()));
  }
  return blocks;
}

/// Two supports that hold one point at different places.
void reject_contradiction(TableReader& table, const Support& support, Reading& reading) {
  const Block* block = reading.sound_block(support.block);
  if (block == nullptr) return;
  const auto differ = [](const auto& a, const auto& b) { return a && b && *a != *b; };
  for (const Support& other : reading.scene.supports) {
    if (other.block != support.block || (other.point_m - support.point_m).norm() > tolerance_m(*block)) continue;
    if (!differ(other.displacement_x_m, support.displacement_x_m) &&
        !differ(other.displacement_y_m, support.displacement_y_m))
      continue;
    reading.problems.error(
        table.place(),
        fmt::format("{} leads point ({}, {}) of block \"{}\" elsewhere than another [[support]] does", table.name(),
                    support.point_m.x(), support.point_m.y(), block->name),
        "one path for a point", "leave one of the two out, or move its point");
    return;
  }
}

}  // namespace

void read_supports(Reading& reading) {
  reading.each("support", [&](TableReader& table) {
    Support support;
    read_point_on_block(table, reading, support.block, support.point_m);
    read_course(table, "displacement_x_m", support.displacement_x_m, reading, Course::displacement);
    read_course(table, "displacement_y_m", support.displacement_y_m, reading, Course::displacement);
    if (!table.has("displacement_x_m") && !table.has("displacement_y_m")) {
      reject(table, reading.problems, "holds nothing", "displacement_x_m, displacement_y_m or both",
             "write displacement_y_m = 0 to hold the point in y");
    }
    reject_contradiction(table, support, reading);
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
  reading.each("face_pressure", [&](TableReader& table) {
    FacePressure load;
    read_face(table, reading, load);
    std::optional<TimeTable> uniform;
    std::optional<TimeTable> from;
    std::optional<TimeTable> to;
    read_course(table, "pressure_pa", uniform, reading);
    read_course(table, "pressure_from_pa", from, reading);
    read_course(table, "pressure_to_pa", to, reading);
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

void read_line_loads(Reading& reading) {
  reading.each("line_load", [&](TableReader& table) {
    LineLoad load;
    read_face(table, reading, load);
    const bool x = read_ends(table, reading, "force_x_n_per_m2", "force_from_x_n_per_m2", "force_to_x_n_per_m2",
                             load.force_from_n_per_m2[0], load.force_to_n_per_m2[0]);
    const bool y = read_ends(table, reading, "force_y_n_per_m2", "force_from_y_n_per_m2", "force_to_y_n_per_m2",
                             load.force_from_n_per_m2[1], load.force_to_n_per_m2[1]);
    const bool any = table.has("force_x_n_per_m2") || table.has("force_y_n_per_m2") ||
                     table.has("force_from_x_n_per_m2") || table.has("force_from_y_n_per_m2");
    if (!x || !y || !any) {
      reject(table, reading.problems, "does not state one force",
             "force_x_n_per_m2, force_y_n_per_m2, or for either axis both force_from_... and force_to_...",
             "keep one of the two ways for each axis");
    }
    reading.scene.line_loads.push_back(std::move(load));
  });
}

void read_body_loads(Reading& reading) {
  reading.each("body_load", [&](TableReader& table) {
    BodyLoad load{.blocks = read_loaded_blocks(table, reading)};
    std::optional<TimeTable> acceleration[2];
    std::optional<TimeTable> force[2];
    read_course(table, "acceleration_x_m_per_s2", acceleration[0], reading);
    read_course(table, "acceleration_y_m_per_s2", acceleration[1], reading);
    read_course(table, "force_x_n_per_m3", force[0], reading);
    read_course(table, "force_y_n_per_m3", force[1], reading);
    load.per_mass = table.has("acceleration_x_m_per_s2") || table.has("acceleration_y_m_per_s2");
    if (load.per_mass == (table.has("force_x_n_per_m3") || table.has("force_y_n_per_m3"))) {
      reject(table, reading.problems, load.per_mass ? "states both acceleration and force" : "has no load",
             "acceleration_x_m_per_s2 and acceleration_y_m_per_s2, or force_x_n_per_m3 and force_y_n_per_m3",
             "keep one of the two ways");
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      load.value[axis] = acceleration[axis].value_or(force[axis].value_or(TimeTable::constant(0)));
    }
    reading.scene.body_loads.push_back(std::move(load));
  });
}

}  // namespace blockweir::scene
