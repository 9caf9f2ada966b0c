// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the folder of cases.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace blockweir::study {

/// The cases of the source tree or of an installation, at a fixed place relative to the program. Throws
/// std::invalid_argument if there are none.
inline std::filesystem::path cases_folder() {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : {"../../../cases", "../share/blockweir/cases"}) {
    if (std::filesystem::is_directory(here / place)) return std::filesystem::canonical(here / place);
  }
  throw std::invalid_argument("there is no folder of cases beside the program; name the cases");
}

/// The name of a case or scene file in tables.
inline std::string case_name(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? std::filesystem::canonical(path).filename() : path.stem();
}

/// All case folders, sorted by name.
inline std::vector<std::filesystem::path> all_cases() {
  std::vector<std::filesystem::path> cases;
  for (const auto& entry : std::filesystem::directory_iterator(cases_folder())) {
    if (std::filesystem::exists(entry.path() / "scene.toml")) cases.push_back(entry.path());
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

}  // namespace blockweir::study
