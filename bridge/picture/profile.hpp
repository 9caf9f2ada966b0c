// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir profile: the computing time of a run, as a tree and a picture, from its summary.json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::picture {

struct ProfileOptions {
  std::filesystem::path run;  ///< folder of a run
  bool svg = false;
};

/// The tree: seconds and share of the wall time for each side and phase, the uncounted rest, skipped work, counts and
/// memory.
[[nodiscard]] std::string profile_tree(const nlohmann::json& summary);

/// Prints the tree and draws it as profile.png (or .svg) in the run's folder. Throws std::invalid_argument if the
/// folder contains no run, std::runtime_error if gnuplot is missing.
void profile(const ProfileOptions& options);

}  // namespace blockweir::picture
