// SPDX-License-Identifier: GPL-3.0-or-later
// Random convex polygons that are about to fall into a heap, in a box of their own or between blocks of the scene.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bridge/geometry/uniform.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

using geometry::Uniform;

struct Heap {
  std::string name;
  Point origin_m = Point::Zero();  ///< the box's lower upstream corner, inside
  double width_m = 0;
  double size_m = 0;  ///< largest diameter of a block
  int blocks = 20;
  int corners = 0;  ///< of a block; 0: 3 to 6, at random
  int seed = 1;
  bool box = true;
};

/// Corners on a circle, so that the polygon is convex, none nearer to the next than a third of the mean distance.
std::vector<Point> random_polygon(const Point& centre, const Heap& heap, Uniform& uniform) {
  const double radius = heap.size_m / 2 * (0.6 + 0.4 * uniform());
  const double corners = heap.corners > 0 ? heap.corners : 3 + std::floor(4 * uniform());
  const double turn = uniform();
  std::vector<Point> polygon;
  for (double k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * ((k + 2 * uniform() / 3) / corners + turn);
    polygon.emplace_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

std::vector<Point> rectangle(const Point& low, const Point& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

void read_heap(TableReader& table, Reading& reading) {
  Heap heap;
  Block block;
  const Range length = drawn_length();
  const std::size_t errors = reading.problems.count();
  table.text("name", heap.name, true);
  block.material = table.reference("material", reading.materials);
  block.line = table.place().line;
  table.point("origin_m", heap.origin_m);
  table.number("width_m", heap.width_m, length, true);
  table.number("size_m", heap.size_m, length, true);
  table.integer("blocks", heap.blocks, 1, most_blocks);
  table.integer("corners", heap.corners, 3);
  table.integer("seed", heap.seed, 0);
  table.flag("box", heap.box);
  if (reading.problems.count() > errors || !few_enough(reading, table, heap.blocks)) return;
  if (heap.size_m > heap.width_m) {
    reading.problems.error(
        table.place(),
        fmt::format("{} has {} blocks of {} m in a box of {} m", table.name(), heap.blocks, heap.size_m, heap.width_m),
        "blocks none wider than the box", "make smaller blocks, or a wider box");
    return;
  }

  // Each polygon has a square of the box to itself.
  const double columns = std::floor(heap.width_m / heap.size_m);
  const double cell = heap.width_m / columns;
  const double height = cell * std::ceil(heap.blocks / columns);
  const auto add = [&](const std::string& name, std::vector<Point> vertices, bool fixed) {
    Block part = block;
    part.name = heap.name + name;
    part.vertices = std::move(vertices);
    part.fixed = fixed;
    add_made_block(reading, table, std::move(part));
  };
  const auto wall = [&](const std::string& name, double x0, double y0, double x1, double y1) {
    add(name, rectangle(heap.origin_m + Point(x0, y0), heap.origin_m + Point(x1, y1)), true);
  };
  if (heap.box) {
    wall("-floor", -cell, -cell, heap.width_m + cell, 0);
    wall("-left", -cell, 0, 0, height);
    wall("-right", heap.width_m, 0, heap.width_m + cell, height);
  }
  Uniform uniform(static_cast<std::uint64_t>(heap.seed));
  for (int k = 0; k < heap.blocks; ++k) {
    const Point centre(std::fmod(k, columns) + 0.5, std::floor(k / columns) + 0.5);
    add(std::to_string(k + 1), random_polygon(heap.origin_m + cell * centre, heap, uniform), false);
  }
}

}  // namespace

void read_heaps(Reading& reading) {
  reading.each("heap", [&](TableReader& table) { read_heap(table, reading); });
}

}  // namespace blockweir::scene
