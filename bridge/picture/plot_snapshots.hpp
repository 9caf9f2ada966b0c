// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the section at chosen times, from frames.jsonl.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/picture/draw.hpp"

namespace blockweir::picture {

/// `snapshots` (six frames) and `picture` (one), and animation.gif with all frames if requested; `ending` chooses PNG
/// or SVG.
std::vector<Picture> snapshot_pictures(const std::filesystem::path& run, const nlohmann::json& summary,
                                       const std::string& ending, bool animated);

}  // namespace blockweir::picture
