// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir stress: maps of stability, each cell right, refused with a reason, or wrong.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/study/engine_options.hpp"

namespace blockweir::study {

struct StressOptions {
  std::vector<std::string> names;             ///< of scenes in cases/stress, or scene files; empty: all in cases/stress
  std::filesystem::path out = "runs/stress";  ///< folder for tables and pictures
  bool brief = false;                         ///< only the first, the middle and the last value of each key
  EngineOptions engine{};
};

/// Prints each map and then a row for each, draws them in a folder a scene and writes stress.json. Returns 1 when a
/// cell is wrong, else 0.
int stress(const StressOptions& options);

}  // namespace blockweir::study
