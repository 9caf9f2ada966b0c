// SPDX-License-Identifier: GPL-3.0-or-later
// Masonry by its measures: arches of voussoirs and walls of bricks, as ordinary blocks.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

constexpr int most_voussoirs = 10'000;  // slender ones lie in the boxes around many others: reading takes long

int read_count(TableReader& table, Reading& reading, const char* key, int most) {
  int count = 0;
  if (!table.has(key)) {
    reading.problems.error(table.place(), fmt::format("{} has no \"{}\"", table.name(), key),
                           fmt::format("a whole number from 1 to {}", most), fmt::format("add {} = ...", key));
  }
  table.integer(key, count, 1, most);
  return count;
}

/// Points on the ring's radii, the angle counted from the crown, downstream.
class ArchRing {
 public:
  explicit ArchRing(const Arch& arch) : arch_(arch) {}

  [[nodiscard]] Point at(double radius_m, double angle) const {
    return arch_.centre_m + radius_m * Point(std::sin(angle), std::cos(angle));
  }
  /// Counter-clockwise, between two radii.
  [[nodiscard]] std::vector<Point> voussoir(double from, double to) const {
    const double inner = arch_.mean_radius_m - arch_.thickness_m / 2;
    const double outer = arch_.mean_radius_m + arch_.thickness_m / 2;
    return {at(inner, to), at(outer, to), at(outer, from), at(inner, from)};
  }
  /// On the far side of the radius at `angle`, wider than the ring by half its thickness at both ends, so that a hinge
  /// at the ring's edge has ground under it.
  [[nodiscard]] std::vector<Point> springing(double angle) const {
    const double side = angle > 0 ? 1 : -1;
    const Point away = side * arch_.thickness_m * Point(std::cos(angle), -std::sin(angle));
    const Point inner = at(arch_.mean_radius_m - arch_.thickness_m, angle);
    const Point outer = at(arch_.mean_radius_m + arch_.thickness_m, angle);
    if (side > 0) return {inner, inner + away, outer + away, outer};
    return {outer, outer + away, inner + away, inner};
  }

 private:
  const Arch& arch_;
};

void read_arch(TableReader& table, Reading& reading) {
  Arch arch;
  Block block;
  bool springings = true;
  const std::size_t errors = reading.problems.count();
  table.text("name", arch.name, true);
  block.material = table.reference("material", reading.materials);
  block.line = table.place().line;
  table.point("centre_m", arch.centre_m);
  table.number("mean_radius_m", arch.mean_radius_m, drawn_length(), true);
  const double radius = arch.mean_radius_m;
  table.number(
      "thickness_m", arch.thickness_m,
      {[radius](double t) { return t > 0 && (t < radius || radius == 0); }, "a number above 0, below mean_radius_m"},
      true);
  table.number("embrace_deg", arch.embrace_deg,
               {[](double e) { return e > 0 && e <= 180; }, "an angle above 0, up to 180 degrees"});
  table.flag("springings", springings);
  arch.voussoirs = read_count(table, reading, "voussoirs", most_voussoirs);
  const bool sound = reading.problems.count() == errors && few_enough(reading, table, arch.voussoirs, most_voussoirs);
  reading.scene.arches.push_back(arch);  // a wrong one too: what names it is right
  if (!sound) return;

  const ArchRing ring(arch);
  const double half = arch.embrace_deg * std::numbers::pi / 360;
  const auto radius_of_joint = [&](int i) { return -half + 2 * half * i / arch.voussoirs; };
  const auto add = [&](const std::string& name, std::vector<Point> vertices, bool fixed) {
    Block part = block;
    part.name = arch.name + name;
    part.vertices = std::move(vertices);
    part.fixed = fixed;
    add_made_block(reading, table, std::move(part));
  };
  if (springings) add("-left", ring.springing(-half), true);
  for (int i = 0; i < arch.voussoirs; ++i) {
    add(std::to_string(i + 1), ring.voussoir(radius_of_joint(i), radius_of_joint(i + 1)), false);
  }
  if (springings) add("-right", ring.springing(half), true);
}

enum class Bond { running, stacked };

struct Wall {
  std::string name;
  Point origin_m = Point::Zero();  ///< its lower upstream corner
  Point brick_m = Point::Ones();   ///< length and height
  int rows = 0;
  int columns = 0;
  Bond bond = Bond::running;
  bool fixed_base = false;
};

/// Ends of the bricks in a row, in bricks; in running bond every other row begins and ends with half a brick.
std::vector<double> brick_ends(const Wall& wall, int row) {
  const bool shifted = wall.bond == Bond::running && row % 2 == 1;
  std::vector<double> ends{0};
  for (int c = shifted ? 0 : 1; c < wall.columns; ++c) ends.push_back(c + (shifted ? 0.5 : 0));
  ends.push_back(wall.columns);
  return ends;
}

void read_wall(TableReader& table, Reading& reading) {
  Wall wall;
  Block block;
  const Range length = drawn_length();
  const std::size_t errors = reading.problems.count();
  table.text("name", wall.name, true);
  block.material = table.reference("material", reading.materials);
  block.line = table.place().line;
  table.point("origin_m", wall.origin_m);
  table.number("brick_length_m", wall.brick_m.x(), length, true);
  table.number("brick_height_m", wall.brick_m.y(), length, true);
  table.choice<Bond>("bond", wall.bond, {{"running", Bond::running}, {"stacked", Bond::stacked}});
  table.flag("fixed_base", wall.fixed_base);
  table.point("initial_velocity_m_per_s", block.initial_velocity_m_per_s);
  wall.rows = read_count(table, reading, "rows", most_blocks);
  wall.columns = read_count(table, reading, "columns", most_blocks);
  if (reading.problems.count() > errors || !few_enough(reading, table, 1.0 * wall.rows * wall.columns)) return;

  for (int row = 0; row < wall.rows; ++row) {
    const std::vector<double> ends = brick_ends(wall, row);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const auto corner = [&](double x, double y) {
        return Point(wall.origin_m + wall.brick_m.cwiseProduct(Point(x, y)));
      };
      Block brick = block;
      brick.name = fmt::format("{}{}-{}", wall.name, row + 1, i + 1);
      brick.vertices = {corner(ends[i], row), corner(ends[i + 1], row), corner(ends[i + 1], row + 1),
                        corner(ends[i], row + 1)};
      brick.fixed = wall.fixed_base && row == 0;
      add_made_block(reading, table, std::move(brick));
    }
  }
}

}  // namespace

void read_arches(Reading& reading) {
  reading.each("arch", [&](TableReader& table) { read_arch(table, reading); });
}

void read_walls(Reading& reading) {
  reading.each("wall", [&](TableReader& table) { read_wall(table, reading); });
}

}  // namespace blockweir::scene
