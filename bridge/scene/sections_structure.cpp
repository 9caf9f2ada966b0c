// SPDX-License-Identifier: GPL-3.0-or-later
// What stands: materials, blocks and the joints between them.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "bridge/scene/nearest.hpp"
#include "bridge/scene/outline.hpp"
#include "bridge/scene/polygon.hpp"
#include "bridge/scene/sections.hpp"

namespace blockweir::scene {
namespace {

Range poissons_ratio(Plane plane) {
  if (plane == Plane::strain) {
    return {[](double nu) { return nu >= 0 && nu < 0.5; }, "a number of at least 0 and below 0.5 (plane strain)"};
  }
  return {[](double nu) { return nu >= 0 && nu <= 0.5; }, "a number from 0 to 0.5 (plane stress)"};
}

/// Leaves in `vertices` a sound counter-clockwise outline, or none.
void mend_outline(TableReader& table, Block& block, Problems& problems) {
  if (const auto fault = outline_fault(block.vertices)) {
    problems.error(table.place("vertices_m", fault->vertex), fmt::format("block \"{}\" {}", block.name, fault->found),
                   fault->expected, fault->remedy);
    block.vertices.clear();
  } else if (signed_area(block.vertices) < 0) {
    problems.note(table.place("vertices_m"), fmt::format("block \"{}\" runs clockwise", block.name),
                  "it was taken the other way round");
    // The first vertex stays first.
    std::reverse(block.vertices.begin() + 1, block.vertices.end());
  }
}

void read_block(TableReader& table, Reading& reading) {
  Block block;
  block.line = table.place().line;
  table.text("name", block.name, true);
  block.material = table.reference("material", reading.materials);
  if (table.points("vertices_m", block.vertices)) mend_outline(table, block, reading.problems);
  table.flag("fixed", block.fixed);
  table.point("initial_velocity_m_per_s", block.initial_velocity_m_per_s);
  table.number("initial_spin_deg_per_s", block.initial_spin_deg_per_s);
  if (!reading.blocks.add(block.name) && !block.name.empty()) {
    reading.problems.error(table.place("name"), fmt::format("a second block is called \"{}\"", block.name),
                           "names that differ", "rename one of them");
  }
  reading.scene.blocks.push_back(std::move(block));
}

/// `residual_given`: whether [joint] or this table states the residual angle; else it is the peak angle.
void read_law(TableReader& table, JointLaw& law, bool& residual_given) {
  const Range angle{[](double degrees) { return degrees >= 0 && degrees < 90; },
                    "an angle of at least 0 and below 90 degrees"};
  table.number("friction_angle_deg", law.friction_angle_deg, angle);
  if (table.number("residual_friction_angle_deg", law.residual_friction_angle_deg, angle)) residual_given = true;
  if (!residual_given) law.residual_friction_angle_deg = law.friction_angle_deg;
  table.number("cohesion_pa", law.cohesion_pa, not_negative());
  table.number("tension_strength_pa", law.tension_strength_pa, not_negative());
  table.number("bonded_length_m", law.bonded_length_m, not_negative());
  table.flag("keeps_cohesion", law.keeps_cohesion);
  table.choice<Uplift>("uplift", law.uplift,
                       {{"none", Uplift::none}, {"triangular", Uplift::triangular}, {"full", Uplift::full}});
}

std::array<int, 2> read_between(TableReader& table, Reading& reading) {
  std::array<int, 2> between{-1, -1};
  std::vector<std::string> words;
  if (!table.texts("between", words, 2)) return between;
  for (std::size_t i = 0; i < 2; ++i) {
    between[i] = reading.blocks.find(words[i]);
    if (between[i] >= 0) continue;
    reading.problems.error(table.place("between", i),
                           fmt::format("between in {} names no block: \"{}\"", table.name(), words[i]),
                           one_of(reading.blocks.list()), did_you_mean(words[i], reading.blocks.list()));
  }
  if (between[0] >= 0 && between[0] == between[1]) {
    reading.problems.error(table.place("between"),
                           fmt::format("{} joins block \"{}\" to itself", table.name(), words[0]),
                           "two different blocks", "name the block on its other side");
  }
  return between;
}

}  // namespace

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
    if (!node.is_table()) {
      problems.error(problems.at(node.source()), fmt::format("material.{} is not a section", material.name),
                     "[material.NAME]", "give each material a name and a section of its own");
    } else {
      TableReader table(problems, node.as_table(), fmt::format("[material.{}]", material.name));
      table.number("youngs_modulus_pa", material.youngs_modulus_pa, positive(), true);
      table.number("poissons_ratio", material.poissons_ratio, poissons_ratio(reading.scene.analysis.plane), true);
      table.number("density_kg_per_m3", material.density_kg_per_m3, positive(), true);
    }
    reading.scene.materials.push_back(std::move(material));
  }
}

void read_blocks(Reading& reading) {
  reading.each("block", [&](TableReader& table) { read_block(table, reading); });
  if (!reading.scene.blocks.empty() || reading.file.contains("block")) return;
  reading.problems.error(reading.problems.at(0), "the scene has no block",
                         "[[block]] with name, material and vertices_m", "add the blocks of the structure");
}

void read_joints(Reading& reading) {
  bool residual_given = false;
  {
    TableReader table(reading.problems, reading.section("joint"), "[joint]");
    read_law(table, reading.scene.default_joint, residual_given);
  }
  std::set<std::string> names;
  std::set<std::array<int, 2>> pairs;
  reading.each("joints", [&](TableReader& table) {
    Joint joint{.law = reading.scene.default_joint};
    table.text("name", joint.name, true);
    joint.between = read_between(table, reading);
    bool own_residual = residual_given;
    read_law(table, joint.law, own_residual);
    const auto [low, high] = std::minmax(joint.between[0], joint.between[1]);
    if (!names.insert(joint.name).second && !joint.name.empty()) {
      reading.problems.error(table.place("name"), fmt::format("a second joint is called \"{}\"", joint.name),
                             "names that differ", "rename one of them");
    }
    if (low >= 0 && !pairs.insert({low, high}).second) {
      reading.problems.error(table.place("between"),
                             fmt::format("{} is a second joint of its two blocks", table.name()),
                             "one joint for each pair of blocks", "leave one of the two out");
    }
    reading.scene.joints.push_back(std::move(joint));
  });
}

}  // namespace blockweir::scene
