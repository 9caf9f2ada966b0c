// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the section at chosen times, from frames.jsonl.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::picture {

/// Script for `snapshots` (six moments) and `picture` (one).
std::string snapshot_script(const std::filesystem::path& run, const nlohmann::json& summary,
                            const std::string& terminal, const std::string& ending, bool animated);

}  // namespace blockweir::picture
