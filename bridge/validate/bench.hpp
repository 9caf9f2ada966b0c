// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir bench: wall time against error for the settings in a case's [[bench]]. An engine computes the errors; the
// times are measured on this machine, one run after the other.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/study/engine_options.hpp"

namespace blockweir::study {

struct BenchOptions {
  std::vector<std::filesystem::path> cases;  ///< empty: all cases with a [[bench]]
  std::filesystem::path out = "runs/bench";  ///< folder for the table and one picture for each case
  std::vector<std::string> overrides;
  bool brief = false;    ///< two values for each curve, each timed once
  bool untimed = false;  ///< errors only
  EngineOptions engine{};
};

/// Number of settings in a bench, besides the scene itself. Throws scene::SceneError if the scene is invalid with one
/// of them.
std::size_t bench_settings(const std::filesystem::path& scene, const std::vector<std::string>& overrides);

/// Prints one row for each setting, draws each case, writes bench.json, and lists the scenes for which another setting
/// is better than their own. Returns 1 if a run failed, otherwise 0.
int bench(const BenchOptions& options);

}  // namespace blockweir::study
