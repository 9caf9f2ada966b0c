// SPDX-License-Identifier: GPL-3.0-or-later
// A load case: the scene with some keys changed. `blockweir safety` evaluates it; a run does not need
// it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace blockweir::scene {

struct LoadCase {
  std::string name;
  std::string kind{};                       ///< `class`: usual, unusual, extreme, or a word of the user's
  std::vector<std::string> set{};           ///< changed keys, "dotted.key=value", as for --set
  std::optional<double> required_factor{};  ///< on the strength of joints
  std::string source{};                     ///< where the required factor comes from, e.g. a guideline
  int line = 0;                             ///< where the scene file states it
};

}  // namespace blockweir::scene
