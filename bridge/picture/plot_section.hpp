// SPDX-License-Identifier: GPL-3.0-or-later
// The section as the scene draws it, with joints' names, loads and levels.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::picture {

/// Script for `section`, from the run's own scene.
std::string section_script(const std::filesystem::path& run, const std::string& terminal, const std::string& ending);

}  // namespace blockweir::picture
