// SPDX-License-Identifier: GPL-3.0-or-later
// Bolts between blocks, or between a block and the ground.
#include <fmt/format.h>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

void check_end(TableReader& table, Reading& reading, const char* key, int index, const Point& point) {
  const Block* block = reading.sound_block(index);
  if (block == nullptr ||
      geometry::holds_point(block->vertices, point, 1e-6 * geometry::bounds_of(block->vertices).size()))
    return;
  reading.problems.error(
      table.place(key),
      fmt::format("{} ({}, {}) in {} is outside block \"{}\"", key, point.x(), point.y(), table.name(), block->name),
      "a point in the block or on its outline", "move the point or name the block that it is on");
}

/// Reports an end in the ground that lies inside a block that moves: it would hold that block to nothing that is there,
/// and a block that was forgotten would make a dam look safer. On an outline, as on a rock's edge, it may be either's.
void refuse_ground_in_block(TableReader& table, Reading& reading, const Bolt& bolt) {
  const Point& point = bolt.to_m;
  for (const Block& block : reading.scene.blocks) {
    if (block.fixed || block.vertices.empty()) continue;
    const double tolerance_m = 1e-6 * geometry::bounds_of(block.vertices).size();
    const auto holds = [&](double x, double y) {
      return geometry::holds_point(block.vertices, {point.x() + x, point.y() + y}, 0);
    };
    // Inside is where small steps to all sides stay in the block.
    if (!holds(tolerance_m, tolerance_m) || !holds(-tolerance_m, tolerance_m) || !holds(tolerance_m, -tolerance_m) ||
        !holds(-tolerance_m, -tolerance_m))
      continue;
    reading.problems.error(
        table.place("to_m"),
        fmt::format(
            "to_m ({}, {}) in {} lies within block \"{}\", which moves, and no to_block is stated, which stands "
            "for the ground",
            point.x(), point.y(), table.name(), block.name),
        "an end in the ground outside all blocks that move",
        &block == reading.sound_block(bolt.blocks[0])
            ? "move the point into the ground: one end is in this block already"
            : fmt::format("state to_block = \"{0}\", or fixed = true in block \"{0}\" if it is the ground, or move the "
                          "point into the ground",
                          block.name));
    return;
  }
}

/// Warns of an end in the ground that lies in no block, and above ground: it is taken to hold, though in the air.
void warn_of_ground_in_air(TableReader& table, Reading& reading, const Point& point) {
  const Block* below = nullptr;
  for (const Block& block : reading.scene.blocks) {
    if (block.vertices.empty()) continue;
    const geometry::Bounds box = geometry::bounds_of(block.vertices);
    if (geometry::holds_point(block.vertices, point, 1e-6 * box.size())) return;
    const bool under = box.low.x() <= point.x() && point.x() <= box.high.x() && box.high.y() < point.y();
    if (block.fixed && under) below = &block;
  }
  if (below == nullptr) return;
  reading.problems.warning(
      table.place("to_m"),
      fmt::format("to_m ({}, {}) in {} is in the air above block \"{}\", and no to_block is stated, which stands for "
                  "the ground: it holds all the same",
                  point.x(), point.y(), table.name(), below->name),
      "an end in the ground", "is a sign wrong? move the point into the ground, or name the block that it is on");
}

/// Reports a bolt neither of whose ends can move.
void require_movable_end(TableReader& table, Reading& reading, const Bolt& bolt) {
  const Block* from = reading.sound_block(bolt.blocks[0]);
  const Block* to = reading.sound_block(bolt.blocks[1]);
  const bool to_holds = table.has("to_block") ? to != nullptr && to->fixed : true;
  if (from == nullptr || !from->fixed || !to_holds) return;
  reading.problems.error(table.place("from_block"),
                         fmt::format("{} has no effect: neither of its ends can move", table.name()),
                         "a block that can move at one end", "leave it out, or name the block that it is to hold");
}

/// Given, or E A/L.
void read_stiffness(TableReader& table, Reading& reading, Bolt& bolt) {
  double modulus = 0;
  double area = 0;
  table.number("stiffness_n_per_m2", bolt.stiffness_n_per_m2, positive());
  table.number("youngs_modulus_pa", modulus, positive());
  table.number("area_m2_per_m", area, positive());
  const bool bar = table.has("youngs_modulus_pa") && table.has("area_m2_per_m");
  const bool part = table.has("youngs_modulus_pa") != table.has("area_m2_per_m");
  if (part || bar == table.has("stiffness_n_per_m2")) {
    reading.problems.error(table.place(), fmt::format("{} does not state one stiffness", table.name()),
                           "stiffness_n_per_m2, or both youngs_modulus_pa and area_m2_per_m",
                           "keep one of the two ways");
  }
  if (bar) bolt.stiffness_n_per_m2 = modulus * area / (bolt.to_m - bolt.from_m).norm();
}

}  // namespace

void read_bolts(Reading& reading) {
  reading.each("bolt", [&](TableReader& table) {
    Bolt bolt;
    table.text("name", bolt.name, true);
    bolt.blocks = {table.reference("from_block", reading.blocks), table.reference("to_block", reading.blocks, false)};
    const bool ends = table.point("from_m", bolt.from_m, true) && table.point("to_m", bolt.to_m, true);
    if (ends && bolt.from_m == bolt.to_m) {
      reading.problems.error(table.place("to_m"), fmt::format("{} has no length", table.name()),
                             "two points that differ", "move one of them");
    }
    if (bolt.blocks[0] >= 0 && bolt.blocks[0] == bolt.blocks[1]) {
      reading.problems.error(table.place("to_block"), fmt::format("{} joins a block to itself", table.name()),
                             "two different blocks", "name another, or leave to_block out for the ground");
    }
    require_movable_end(table, reading, bolt);
    if (ends) check_end(table, reading, "from_m", bolt.blocks[0], bolt.from_m);
    if (ends) check_end(table, reading, "to_m", bolt.blocks[1], bolt.to_m);
    if (ends && !table.has("to_block") && bolt.from_m != bolt.to_m) {
      refuse_ground_in_block(table, reading, bolt);
      warn_of_ground_in_air(table, reading, bolt.to_m);
    }
    read_stiffness(table, reading, bolt);
    table.number("prestress_n_per_m", bolt.prestress_n_per_m, not_negative());
    table.number("yield_n_per_m", bolt.yield_n_per_m, positive());
    table.flag("takes_compression", bolt.takes_compression);
    if (bolt.yield_n_per_m && *bolt.yield_n_per_m < bolt.prestress_n_per_m) {
      reading.problems.error(table.place("prestress_n_per_m"),
                             fmt::format("{} is stressed beyond its yield", table.name()),
                             "a prestress up to yield_n_per_m", "lower the prestress");
    }
    if (!bolt.name.empty() && !reading.bolts.add(bolt.name)) {
      refuse_second(reading, table.place("name"), "bolt", bolt.name, {"bolt"});
    }
    reading.scene.bolts.push_back(std::move(bolt));
  });
}

}  // namespace blockweir::scene
