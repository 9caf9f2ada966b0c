// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir level: at which level of its reservoir a scene fails.
#pragma once

#include <filesystem>

#include "bridge/process/ask.hpp"

namespace blockweir::study {

struct LevelOptions : process::AskOptions {
  std::filesystem::path json;  ///< file for the answer; empty: none beside that in the folder
};

/// Tells the level by the blocks' own equilibrium and by limit analysis, and draws the mechanism. Returns 0: a dam that
/// fails is a result.
int tell_level(const LevelOptions& options);

}  // namespace blockweir::study
