// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir profile: where the time of a run went, as a tree and as a picture, from its summary.json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::picture {

struct ProfileOptions {
  std::filesystem::path run;  ///< folder of a run
  bool svg = false;
};

/// The tree: seconds and share of the wall time for each side and phase, what no phase counts, what was skipped, counts
/// and memory.
[[nodiscard]] std::string profile_tree(const nlohmann::json& summary);

/// Prints the tree and draws it as profile.png (or .svg) in the run's folder. Throws std::invalid_argument when the
/// folder holds no run, std::runtime_error when gnuplot is missing.
void profile(const ProfileOptions& options);

}  // namespace blockweir::picture
