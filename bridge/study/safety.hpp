// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir safety: the factor on strength of a scene and of its load cases.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "bridge/process/ask.hpp"

namespace blockweir::study {

struct SafetyOptions : process::AskOptions {
  std::filesystem::path json;  ///< file for the answers; empty: none beside that in the folder
};

/// Of an answer of blockweir-limit: the blocks' factor, or that with crushed corners, with cracked joints or of a bound
/// that it is above, whichever is least. Infinite where no strength is needed, 0 where none would do.
double deciding_factor(const nlohmann::json& answer);

/// The answers for the scene as it stands and each load case, a list as safety.json has it; a folder each in
/// `options.out`, which has to be named. `pictures`: null to draw mechanisms at once; else what draws them is added, so
/// that a disk that is full for a picture costs no answer. Throws as process::ask() does.
nlohmann::json safety_answers(const process::AskOptions& options,
                              std::vector<std::function<void()>>* pictures = nullptr);

/// Tells the factor of the scene as it stands and of each load case, by the blocks' own equilibrium and by limit
/// analysis, with the joints that run through, and draws the mechanisms. Returns 1 where a load case does not reach the
/// factor that it requires, or has no answer; else 0.
int tell_safety(const SafetyOptions& options);

}  // namespace blockweir::study
