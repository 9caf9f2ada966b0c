// SPDX-License-Identifier: GPL-3.0-or-later
// The cuts of a section: lines, with the law and name of the joints along each, and regions of other materials.
#pragma once

#include <string>
#include <vector>

#include "bridge/geometry/cut.hpp"
#include "bridge/geometry/outline.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

struct Cuts {
  /// Where the file states it, for messages.
  struct Source {
    std::string name;  ///< "[[cut]] \"crack\""
    Place place;
    Place bonded_length;
    bool states_bond_length = false;
    bool by_chance = false;  ///< a joint set with rock bridges, which may separate nothing
  };

  std::vector<geometry::Line> lines;
  std::vector<Joint> joints;    ///< by id of the line; not yet assigned to blocks
  std::vector<Source> sources;  ///< by id of the line; those of regions have no name

  int add(const std::string& name, const JointLaw& law, Source source) {
    joints.push_back({.name = name, .between = {-1, -1}, .law = law});
    sources.push_back(std::move(source));
    return static_cast<int>(joints.size()) - 1;
  }
};

/// Blocks in the region have its material and mesh size, and may be fixed.
struct Region {
  std::string name{};
  int material = 0;
  bool fixed = false;
  double mesh_size_m = 0;
  std::vector<Point> outline;
  Place place{};
  bool used = false;  ///< some block lies in it
};

constexpr std::size_t most_cut_lines = 5000;  // of a section

/// The source of a cut or joint set that this table states.
inline Cuts::Source source_of(const TableReader& table, bool by_chance = false) {
  return {.name = table.name(),
          .place = table.place(),
          .bonded_length = table.place("bonded_length_m"),
          .states_bond_length = table.has("bonded_length_m"),
          .by_chance = by_chance};
}

/// The lines of all [[joint_set]] in a section of these bounds, each within its region.
void read_joint_sets(Reading& reading, const geometry::Bounds& bounds, const std::vector<Region>& regions, Cuts& cuts);

/// Reports cuts that separate nothing, laws without a joint, and bonds longer than their joints. The pieces are the
/// scene's blocks from `first_block` on.
void check_cuts(Reading& reading, const Cuts& cuts, const geometry::Cut& cut, std::size_t first_block);

}  // namespace blockweir::scene
