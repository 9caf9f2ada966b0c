// SPDX-License-Identifier: GPL-3.0-or-later
// The section as the scene draws it, with joints' names, and the loads, levels and bolts' forces of the failure or the
// run's end.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/picture/draw.hpp"

namespace blockweir::picture {

/// `section`, from the run's own scene; `ending` chooses PNG or SVG.
Picture section_picture(const std::filesystem::path& run, const nlohmann::json& summary, const std::string& ending);

}  // namespace blockweir::picture
