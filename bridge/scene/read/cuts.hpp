// SPDX-License-Identifier: GPL-3.0-or-later
// What cuts a section: lines, and the law and name of the joints along each.
#pragma once

#include <string>
#include <vector>

#include "bridge/geometry/cut.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

struct Cuts {
  /// Where the file states it, to say so.
  struct Source {
    std::string name;  ///< "[[cut]] \"crack\""
    Place place;
    Place bonded_length;
    bool states_bond_length = false;
    bool by_chance = false;  ///< a set of joints with bridges may part nothing
  };

  std::vector<geometry::Line> lines;
  std::vector<Joint> joints;    ///< by a line's id; without blocks yet
  std::vector<Source> sources;  ///< likewise; those of regions have no name

  int add(const std::string& name, const JointLaw& law, Source source) {
    joints.push_back({.name = name, .between = {-1, -1}, .law = law});
    sources.push_back(std::move(source));
    return static_cast<int>(joints.size()) - 1;
  }
};

/// Reports cuts that part nothing, laws that no joint has, and bonds longer than their joints. The pieces are the
/// scene's blocks from `first_block` on.
void check_cuts(Reading& reading, const Cuts& cuts, const geometry::Cut& cut, std::size_t first_block);

}  // namespace blockweir::scene
