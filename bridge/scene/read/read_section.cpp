// SPDX-License-Identifier: GPL-3.0-or-later
// A section cut into blocks: its outline, regions of other materials, cuts and sets of joints.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "bridge/geometry/crossings.hpp"
#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/cuts.hpp"
#include "bridge/scene/read/mesh_size.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

constexpr std::size_t most_crossings = 20000;

bool sound(TableReader& table, Reading& reading, const char* key, const std::string& what,
           const std::vector<Point>& outline) {
  if (outline.empty()) return false;
  const auto fault = geometry::outline_fault(outline);
  if (!fault) return true;
  reading.problems.error(table.place(key), fmt::format("{} {}", what, fault->found), fault->expected, fault->remedy);
  return false;
}

std::vector<Region> read_regions(Reading& reading, double mesh_size_m, Cuts& cuts) {
  std::vector<Region> regions;
  reading.each("region", [&](TableReader& table) {
    Region region{.mesh_size_m = mesh_size_m, .outline = {}, .place = table.place()};
    table.text("name", region.name);
    region.material = table.reference("material", reading.materials);
    table.flag("fixed", region.fixed);
    table.points("outline_m", region.outline);
    read_mesh_size(table, reading, region.fixed ? "fixed" : nullptr, region.outline, region.mesh_size_m);
    if (!sound(table, reading, "outline_m", "the outline of a region", region.outline)) return;
    std::vector<Point> ring = region.outline;
    ring.push_back(ring.front());
    cuts.lines.push_back({ring, cuts.add("region", reading.scene.default_joint, {})});
    regions.push_back(std::move(region));
  });
  return regions;
}

void read_cuts(Reading& reading, Cuts& cuts) {
  reading.each("cut", [&](TableReader& table) {
    std::string name;
    JointLaw law = reading.scene.default_joint;
    std::vector<Point> points;
    table.text("name", name, true);
    table.know("drawn");  // by a drawing: repeated_names() looks at it
    table.points("points_m", points, 2);
    bool own_residual = reading.residual_given;
    read_law(table, law, reading, own_residual);
    check_law(table, law, reading, /*of_all=*/false);
    cuts.lines.push_back({points, cuts.add(name, law, source_of(table))});
  });
}

/// Whether the section can be cut in a reasonable time.
bool few_enough_cuts(Reading& reading, TableReader& table, const geometry::Section& section, const Cuts& cuts) {
  const std::size_t lines = geometry::count_segments(section, cuts.lines);
  const auto refuse = [&](const std::string& found, std::size_t most) {
    reading.problems.error(table.place(), found, fmt::format("at most {}", most),
                           "make the spacing of its joints larger");
    return false;
  };
  if (lines > most_cut_lines)
    return refuse(fmt::format("the section has {} edges, cuts and joints", lines), most_cut_lines);
  if (geometry::count_crossings(section, cuts.lines, most_crossings) > most_crossings)
    return refuse("edges, cuts and joints of the section cross too often", most_crossings);
  return true;
}

/// Holes that overlap, reach beyond the outline or share an edge with it would count as blocks.
void check_holes(Reading& reading, TableReader& table, const geometry::Section& section, const geometry::Cut& cut) {
  double left = std::abs(geometry::signed_area(section.outline));
  const double tolerance = 1e-6 * left;
  for (const auto& hole : section.holes) left -= std::abs(geometry::signed_area(hole));
  double blocks = 0;
  for (const geometry::Piece& piece : cut.pieces) blocks += geometry::signed_area(piece.vertices);
  if (!cut.enclosed.empty() || std::abs(blocks - left) <= tolerance) return;
  reading.problems.error(
      table.place("holes_m"),
      fmt::format("the blocks of the section have {:.6g} m2, its outline less its holes {:.6g} m2", blocks, left),
      "holes inside the outline that share no edge or area with it or each other",
      "move them, or draw the outline around");
}

/// A point of the block near the middle of its longest edge: centroids may lie outside.
Point inner_point(const std::vector<Point>& outline) {
  Point best = outline.front();
  double longest = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point span = outline[(i + 1) % outline.size()] - outline[i];
    if (span.norm() <= longest) continue;
    longest = span.norm();
    best = outline[i] + span / 2 + 1e-6 * Point(-span.y(), span.x());
  }
  return best;
}

/// All of a block lies in one region or in none, since the regions' edges cut; of several the first counts.
Region& region_of(const Block& block, std::vector<Region>& regions, Region& otherwise) {
  const Point inside = inner_point(block.vertices);
  const auto holds = [&](const Region& region) { return geometry::holds_point(region.outline, inside, 0); };
  const auto found = std::find_if(regions.begin(), regions.end(), holds);
  return found == regions.end() ? otherwise : *found;
}

/// The pieces as blocks called PREFIX1, PREFIX2, ...; reports regions that have none.
void add_blocks(Reading& reading, const TableReader& table, const std::string& prefix, const geometry::Cut& cut,
                std::vector<Region>& regions, Region& whole) {
  const std::size_t first = reading.scene.blocks.size();
  for (const geometry::Piece& piece : cut.pieces) {
    Block block{.name = fmt::format("{}{}", prefix, reading.scene.blocks.size() - first + 1)};
    block.vertices = piece.vertices;
    Region& region = region_of(block, regions, whole);
    region.used = true;
    block.material = region.material;
    block.fixed = region.fixed;
    block.mesh_size_m = region.fixed ? 0 : region.mesh_size_m;
    block.line = table.place().line;
    reading.blocks.add(block.name);
    reading.scene.blocks.push_back(std::move(block));
  }
  for (const Region& region : regions) {
    if (region.used) continue;
    reading.problems.error(region.place, "[[region]] has no effect: no block of the section lies in it",
                           "an outline that holds some of the section, and that no region before it holds",
                           "move it onto the section, or leave it out");
  }
}

/// Joints along cuts: a single joint has the cut's name; of several, each appends the names of its blocks.
void add_joints(Reading& reading, const geometry::Cut& cut, const Cuts& cuts, std::size_t first_block) {
  const auto cut_of = [&](const geometry::Neighbours& pair) -> const Joint& {
    return cuts.joints[static_cast<std::size_t>(pair.id)];
  };
  std::map<std::string, int> uses;  // several cuts may share a name
  for (const geometry::Neighbours& pair : cut.neighbours) ++uses[cut_of(pair).name];
  for (const geometry::Neighbours& pair : cut.neighbours) {
    Joint joint = cut_of(pair);
    joint.between = {static_cast<int>(first_block) + pair.a, static_cast<int>(first_block) + pair.b};
    joint.set = joint.name;
    if (uses[joint.name] > 1) {
      const auto name = [&](int b) { return reading.scene.blocks[static_cast<std::size_t>(b)].name; };
      joint.name += fmt::format(", {} and {}", name(joint.between[0]), name(joint.between[1]));
    }
    reading.scene.joints.push_back(std::move(joint));
  }
}

/// Holds each point in the block that has it, the first of several.
void hold(Reading& reading, TableReader& table, const std::vector<Point>& points, std::size_t first, double tolerance) {
  auto& blocks = reading.scene.blocks;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto block =
        std::find_if(blocks.begin() + static_cast<std::ptrdiff_t>(first), blocks.end(),
                     [&](const Block& b) { return geometry::holds_point(b.vertices, points[i], tolerance); });
    if (block == blocks.end()) {
      reading.problems.error(
          table.place("held_points_m", i),
          fmt::format("no block of the section has the point ({}, {})", points[i].x(), points[i].y()),
          "points of the section", "move it onto the section");
      continue;
    }
    reading.scene.supports.push_back({.block = static_cast<int>(block - blocks.begin()),
                                      .point_m = points[i],
                                      .displacement_x_m = TimeTable::constant(0),
                                      .displacement_y_m = TimeTable::constant(0)});
  }
}

}  // namespace

void read_section(Reading& reading) {
  const toml::table* given = reading.section("section");
  TableReader table(reading.problems, given, "[section]");
  Cuts cuts;
  std::string prefix = "s";
  geometry::Section section;
  std::vector<Point> held;
  Region whole{.material = -1};
  if (table.present()) {
    table.text("name_prefix", prefix);
    whole.material = table.reference("material", reading.materials);
    table.flag("fixed", whole.fixed);
    table.points("outline_m", section.outline);
    table.outlines("holes_m", section.holes);
    read_mesh_size(table, reading, whole.fixed ? "fixed" : nullptr, section.outline, whole.mesh_size_m);
    table.know("held_points_m");
    if (table.has("held_points_m")) table.points("held_points_m", held, 1);
  }
  bool ready = sound(table, reading, "outline_m", "the section's outline", section.outline);
  for (const auto& hole : section.holes)
    ready = ready && sound(table, reading, "holes_m", "a hole of the section", hole);
  const geometry::Bounds bounds =
      ready ? geometry::bounds_of(section.outline) : geometry::Bounds{Point::Zero(), Point::Ones()};
  const std::size_t errors = reading.problems.count();
  read_cuts(reading, cuts);  // first, as a cut along the outline of a region gives that its law
  std::vector<Region> regions = read_regions(reading, whole.mesh_size_m, cuts);
  read_joint_sets(reading, bounds, regions, cuts);
  if (!table.present() && !cuts.joints.empty()) {
    reading.problems.error(reading.problems.at(0),
                           "[[region]], [[cut]] and [[joint_set]] cut a section, and there is none",
                           "[section] with material and outline_m", "add the section, or leave them out");
  }
  if (!ready || reading.problems.count() > errors || !few_enough_cuts(reading, table, section, cuts)) return;

  const geometry::Cut cut = geometry::cut(section, cuts.lines);
  for (const Point& p : cut.enclosed) {
    reading.problems.error(table.place(),
                           fmt::format("a block encloses a hole or a closed line at ({:.6g}, {:.6g})", p.x(), p.y()),
                           "blocks without holes", "add a [[cut]] from there to the block's outside");
  }
  check_holes(reading, table, section, cut);
  const std::size_t first = reading.scene.blocks.size();
  add_blocks(reading, table, prefix, cut, regions, whole);
  check_cuts(reading, cuts, cut, first);
  add_joints(reading, cut, cuts, first);
  hold(reading, table, held, first, 1e-9 * bounds.size());
}

}  // namespace blockweir::scene
