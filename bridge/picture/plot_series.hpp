// SPDX-License-Identifier: GPL-3.0-or-later
// Figures over time, from history.csv.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::picture {

/// Scripts for displacements, velocities, rotations and level; `terminal` and `ending` choose PNG or SVG.
std::string series_script(const std::filesystem::path& run, const nlohmann::json& summary, const std::string& terminal,
                          const std::string& ending);

}  // namespace blockweir::picture
