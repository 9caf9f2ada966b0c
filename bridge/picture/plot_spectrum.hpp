// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of the ground's acceleration and its response spectrum.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::picture {

/// Script for spectrum.png; empty where the run's ground does not move. `terminal` and `ending` choose PNG or SVG.
std::string spectrum_script(const std::filesystem::path& run, const std::string& terminal, const std::string& ending);

}  // namespace blockweir::picture
