// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir stress: maps of stability; each cell is right, refused with a reason, or wrong.
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

/// Prints each map and a summary row for each, draws them in one folder for each scene and writes stress.json. Returns
/// 1 if a cell is wrong, otherwise 0.
int stress(const StressOptions& options);

}  // namespace blockweir::study
