// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir level: the reservoir level at which a scene fails.
#pragma once

#include <filesystem>

#include "bridge/process/ask.hpp"

namespace blockweir::study {

struct LevelOptions : process::AskOptions {
  std::filesystem::path json;  ///< further file for the answer; empty: none
};

/// Prints the level by equilibrium of the blocks and by limit analysis, and draws the mechanism. Returns 0: a dam that
/// fails is a result.
int print_level(const LevelOptions& options);

}  // namespace blockweir::study
