// SPDX-License-Identifier: GPL-3.0-or-later
// The section as drawn in the scene, with names of joints, and the loads, levels and bolt forces at failure or at the
// end of the run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/picture/draw.hpp"

namespace blockweir::picture {

/// The picture `section`, from the run's own scene; `ending` chooses PNG or SVG.
Picture section_picture(const std::filesystem::path& run, const nlohmann::json& summary, const std::string& ending);

}  // namespace blockweir::picture
