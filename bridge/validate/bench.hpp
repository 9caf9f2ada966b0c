// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir bench: wall time against error, over the settings that a case's [[bench]] names. Errors are found by an
// engine, times on this machine, one run after the other.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/study/engine_options.hpp"

namespace blockweir::study {

struct BenchOptions {
  std::vector<std::filesystem::path> cases;  ///< empty: all that have a [[bench]]
  std::filesystem::path out = "runs/bench";  ///< folder for the table and a picture a case
  std::vector<std::string> overrides;
  bool brief = false;    ///< two values a curve, each timed once
  bool untimed = false;  ///< errors alone
  EngineOptions engine{};
};

/// How many settings a bench of the scene has beside the scene as it stands. Throws scene::SceneError when the scene is
/// not sound with one.
std::size_t bench_settings(const std::filesystem::path& scene, const std::vector<std::string>& overrides);

/// Prints a row a setting, draws each case, writes bench.json, and says which scenes as they stand are bettered by
/// another setting. Returns 1 when a run failed, else 0.
int bench(const BenchOptions& options);

}  // namespace blockweir::study
