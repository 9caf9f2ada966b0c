// SPDX-License-Identifier: GPL-3.0-or-later
// Where the cases are.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace blockweir::study {

/// The cases of the source tree, or of an install: both stand at a fixed place from the program. Throws
/// std::invalid_argument when there are none.
inline std::filesystem::path cases_folder() {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : {"../../../cases", "../share/blockweir/cases"}) {
    if (std::filesystem::is_directory(here / place)) return std::filesystem::canonical(here / place);
  }
  throw std::invalid_argument("there is no folder of cases beside the program; name the cases");
}

/// What tables call a case, or a scene file.
inline std::string case_name(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? std::filesystem::canonical(path).filename() : path.stem();
}

/// Their folders, by name.
inline std::vector<std::filesystem::path> all_cases() {
  std::vector<std::filesystem::path> cases;
  for (const auto& entry : std::filesystem::directory_iterator(cases_folder())) {
    if (std::filesystem::exists(entry.path() / "scene.toml")) cases.push_back(entry.path());
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

}  // namespace blockweir::study
