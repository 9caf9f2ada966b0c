// SPDX-License-Identifier: GPL-3.0-or-later
// Where the cases are.
#pragma once

#include <filesystem>
#include <stdexcept>

namespace blockweir::launch {

/// The cases of the source tree, or of an install: both stand at a fixed place from the program. Throws
/// std::invalid_argument when there are none.
inline std::filesystem::path cases_folder() {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : {"../../../cases", "../share/blockweir/cases"}) {
    if (std::filesystem::is_directory(here / place)) return std::filesystem::canonical(here / place);
  }
  throw std::invalid_argument("there is no folder of cases beside the program; name the cases");
}

}  // namespace blockweir::launch
