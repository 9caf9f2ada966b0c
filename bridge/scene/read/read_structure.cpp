// SPDX-License-Identifier: GPL-3.0-or-later
// Reads materials and blocks.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/mesh_size.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

Range poissons_ratio(Plane plane) {
  if (plane == Plane::strain) {
    return {[](double nu) { return nu >= 0 && nu < 0.5; }, "a number of at least 0 and below 0.5 (plane strain)"};
  }
  return {[](double nu) { return nu >= 0 && nu <= 0.5; }, "a number from 0 to 0.5 (plane stress)"};
}

/// Keys of a block whose motion is settled otherwise.
void check_motion_keys(TableReader& table, Reading& reading, const Block& block) {
  const auto warn = [&](const char* key, const char* why, const char* needs) {
    if (!table.has(key)) return;
    reading.problems.warning(table.place(key),
                             fmt::format("{} of block \"{}\" has no effect: {}", key, block.name, why), needs,
                             fmt::format("leave {} out", key));
  };
  if (block.fixed) {
    for (const char* key : {"initial_velocity_m_per_s", "initial_spin_deg_per_s"}) {
      if (!table.has(key)) continue;
      reading.problems.error(table.place(key), fmt::format("block \"{}\" is fixed and has an {}", block.name, key),
                             "a block that can move", "leave out one of the two");
    }
    if (block.rigid) warn("rigid", "the block is fixed", "a block that can move");
    warn("initial_stress_pa", "the block is fixed", "a block that can move");
  } else if (reading.scene.analysis.kind != AnalysisKind::dynamic) {
    for (const char* key : {"initial_velocity_m_per_s", "initial_spin_deg_per_s"})
      warn(key, "velocities count in a dynamic analysis only", "kind = \"dynamic\" in [analysis]");
  } else if (block.rigid) {
    warn("initial_stress_pa", "the block is rigid", "a block that strains");
  }
}

void read_block(TableReader& table, Reading& reading) {
  Block block;
  block.line = table.place().line;
  table.text("name", block.name, true);
  block.material = table.reference("material", reading.materials);
  if (table.points("vertices_m", block.vertices)) {
    mend_outline(block.vertices, fmt::format("block \"{}\"", block.name), reading.problems,
                 [&](std::size_t vertex) { return table.place("vertices_m", vertex); });
  }
  // One that is wrongly written would have errors that follow from it.
  if (!table.flag("fixed", block.fixed) && table.has("fixed")) block.fixed = true;
  table.flag("rigid", block.rigid);
  table.point("initial_velocity_m_per_s", block.initial_velocity_m_per_s);
  table.number("initial_spin_deg_per_s", block.initial_spin_deg_per_s);
  table.stress("initial_stress_pa", block.initial_stress_pa);
  check_motion_keys(table, reading, block);
  read_mesh_size(table, reading,
                 block.fixed   ? "fixed"
                 : block.rigid ? "rigid"
                               : nullptr,
                 block.vertices, block.mesh_size_m);
  add_block(reading, table.place("name"), std::move(block));
}

/// The table of that line which makes blocks of its own; empty if there is none.
std::string maker_at(const Reading& reading, int line) {
  const auto is_there = [&](const toml::node& node) { return reading.problems.at(node.source()).line == line; };
  for (const char* name : {"section", "arch", "wall", "heap"}) {
    const toml::node* made = reading.file.get(name);
    if (made == nullptr) continue;
    if (made->is_table() && is_there(*made)) return fmt::format("[{}]", name);
    const toml::array* list = made->as_array();
    if (list != nullptr && std::any_of(list->begin(), list->end(), is_there)) return fmt::format("[[{}]]", name);
  }
  return {};
}

/// A name that a block of the scene has already.
void refuse_name(Reading& reading, const Place& place, const std::string& name) {
  const Block& first = reading.scene.blocks[at(reading.blocks.find(name))];
  const std::string maker = maker_at(reading, first.line);
  if (maker.empty()) return refuse_second(reading, place, "block", name, {"block"});
  reading.problems.error(
      place, fmt::format("a second block is called \"{}\", as one that {} of line {} makes", name, maker, first.line),
      "names that differ",
      maker == "[section]" ? "rename the block, or set name_prefix in [section]" : "rename one of them");
}

}  // namespace

void mend_outline(std::vector<Point>& outline, const std::string& whose, Problems& problems,
                  const std::function<Place(std::size_t)>& place_of) {
  if (const auto fault = geometry::outline_fault(outline)) {
    problems.error(place_of(fault->vertex), fmt::format("{} {}", whose, fault->found), fault->expected, fault->remedy);
    outline.clear();
  } else if (geometry::signed_area(outline) < 0) {
    problems.note(place_of(0), fmt::format("{} runs clockwise", whose), "it was taken the other way round");
    // The first vertex stays first.
    std::reverse(outline.begin() + 1, outline.end());
  }
}

void add_block(Reading& reading, const Place& place, Block block) {
  if (!reading.blocks.add(block.name) && !block.name.empty()) refuse_name(reading, place, block.name);
  reading.scene.blocks.push_back(std::move(block));
}

bool few_enough(Reading& reading, TableReader& table, double blocks, double most) {
  constexpr double most_of_all = most_blocks;
  const auto others = reading.scene.blocks.size();
  if (blocks <= most && blocks + static_cast<double>(others) <= most_of_all) return true;
  reading.problems.error(
      table.place(),
      fmt::format("{} has {} blocks{}", table.name(), blocks, others > 0 ? fmt::format(", beside {}", others) : ""),
      fmt::format("at most {} blocks", blocks > most ? most : most_of_all), "make it of fewer blocks");
  return false;
}

void add_made_block(Reading& reading, TableReader& table, Block block) {
  if (const auto fault = geometry::outline_fault(block.vertices)) {
    reading.problems.error(table.place(), fmt::format("block \"{}\" of {} {}", block.name, table.name(), fault->found),
                           fault->expected, "correct the measures");
    block.vertices.clear();
  }
  add_block(reading, table.place("name"), std::move(block));
}

void read_materials(Reading& reading) {
  Problems& problems = reading.problems;
  const toml::table* materials = reading.section("material");
  if (materials == nullptr || materials->empty()) {
    problems.error(problems.at(0), "the scene has no material",
                   "[material.NAME] with youngs_modulus_pa, poissons_ratio and density_kg_per_m3",
                   "add the material of which the blocks are");
    return;
  }
  for (const auto& [key, node] : *materials) {
    Material material;
    material.name = key.str();
    reading.materials.add(material.name);
    constexpr std::size_t longest_name = 200;
    if (material.name.size() > longest_name) {
      problems.error(problems.at(node.source()),
                     fmt::format("a material of a name of {} letters", material.name.size()),
                     fmt::format("at most {}", longest_name), "shorten it");
    }
    if (!node.is_table()) {
      problems.error(problems.at(node.source()), fmt::format("material.{} is not a section", material.name),
                     "[material.NAME]", "give each material a name and a section of its own");
    } else {
      TableReader table(problems, node.as_table(), fmt::format("[material.{}]", material.name));
      table.number("youngs_modulus_pa", material.youngs_modulus_pa, positive(), true);
      table.number("poissons_ratio", material.poissons_ratio, poissons_ratio(reading.scene.analysis.plane), true);
      table.number("density_kg_per_m3", material.density_kg_per_m3, positive(), true);
      table.number("damping_ratio", material.damping_ratio,
                   {[](double zeta) { return zeta >= 0 && zeta <= 1; }, "a number from 0 to 1"});
      std::optional<Eigen::Vector3d> stress;
      if (table.stress("initial_stress_pa", stress)) material.initial_stress_pa = *stress;
    }
    reading.scene.materials.push_back(std::move(material));
  }
}

void read_blocks(Reading& reading) {
  reading.each("block", [&](TableReader& table) { read_block(table, reading); });
  if (!reading.scene.blocks.empty()) return;
  // A generator that is wrong has said so.
  const auto generates = [&](const char* source) { return reading.file.contains(source); };
  constexpr std::array sources = {"block", "section", "arch", "wall", "heap"};
  if (reading.problems.count() > 0 && std::any_of(sources.begin(), sources.end(), generates)) return;
  reading.problems.error(reading.problems.at(0), "the scene has no block",
                         "[[block]] with name, material and vertices_m, or a [section] to be cut",
                         "add the blocks of the structure");
}

}  // namespace blockweir::scene
