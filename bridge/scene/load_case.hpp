// SPDX-License-Identifier: GPL-3.0-or-later
// Loads that a structure is to withstand: the scene with some keys set otherwise. A question about a scene, which no
// run of it needs.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace blockweir::scene {

struct LoadCase {
  std::string name;
  std::string kind{};                       ///< `class`: usual, unusual, extreme, or the user's own words
  std::vector<std::string> set{};           ///< "dotted.key=value", as --set takes them
  std::optional<double> required_factor{};  ///< on the strength of joints
  std::string source{};                     ///< of that
  int line = 0;                             ///< where the scene file states it
};

}  // namespace blockweir::scene
