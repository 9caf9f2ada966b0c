// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir safety: the factor of safety on strength, of a scene and of its load cases.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "bridge/process/ask.hpp"

namespace blockweir::study {

struct SafetyOptions : process::AskOptions {
  std::filesystem::path json;  ///< further file for the answers; empty: none
};

/// The lowest factor in an answer of blockweir-limit: of the blocks, also without strain or listed in another order,
/// with crushed corners, with cracked joints, or of a limit-analysis bound below it. Infinite if no strength is needed,
/// 0 if no strength is enough.
double deciding_factor(const nlohmann::json& answer);
/// Whether an answer reaches the required factor. Null if none is required, or if the blocks have no answer and limit
/// analysis, an upper bound, does not decide either.
nlohmann::json satisfied(const nlohmann::json& answer, const std::optional<double>& required);

/// Appends the answers for the scene itself and each load case to the list `cases`, as in safety.json, with one folder
/// each in `options.out`, which must be set. `pictures`: null to draw mechanisms at once; otherwise the drawing
/// functions are appended, so that a full disk does not lose answers. Throws as process::ask() does; `cases` then has
/// those that were answered.
void safety_answers(const process::AskOptions& options, nlohmann::json& cases,
                    std::vector<std::function<void()>>* pictures = nullptr);

/// Prints the factor of the scene itself and of each load case, by equilibrium of the blocks and by limit analysis,
/// with the joints that run through the structure, and draws the mechanisms. Returns 1 if a load case has no answer or
/// does not reach its required factor; otherwise 0.
int print_safety(const SafetyOptions& options);

}  // namespace blockweir::study
