// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir case: interFoam's case from a scene, without running it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::launch {

struct CaseOptions {
  std::filesystem::path scene;
  std::filesystem::path out = "case";
  std::vector<std::string> overrides{};
};

/// Becomes blockweir-openfoam --case-only, which says the rest; throws std::runtime_error when that is missing.
[[noreturn]] void write_case(const CaseOptions& options);

}  // namespace blockweir::launch
