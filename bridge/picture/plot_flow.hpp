// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of the flow through joints: pressures along a few joints at five times, or a map of many joints at the last
// time; and flow rates over time.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/picture/draw.hpp"

namespace blockweir::picture {

/// The picture `flow`, up to failure; none if no water flows through joints. `ending` chooses PNG or SVG.
std::vector<Picture> flow_picture(const std::filesystem::path& run, const nlohmann::json& summary,
                                  const std::string& ending);

}  // namespace blockweir::picture
