// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir validate: runs every case with expected figures, its variants and its studies, and compares the figures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/study/engine_options.hpp"

namespace blockweir::study {

struct ValidateOptions {
  std::vector<std::filesystem::path> cases;  ///< empty: all of the cases folder
  std::filesystem::path json;                ///< empty: none
  std::vector<std::string> overrides;
  bool sweep = false;  ///< no studies; failing cases are repeated for penalties 5e6, 1e9, 1e12 and steps 1e-2, 1e-3 s
  bool brief = false;  ///< of maps only the first, the middle and the last value of each key
  EngineOptions engine{};
};

/// Prints the table; returns 0 if every figure is within its tolerance, otherwise 1.
int validate(const ValidateOptions& options);

}  // namespace blockweir::study
