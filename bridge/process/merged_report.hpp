// SPDX-License-Identifier: GPL-3.0-or-later
// Merges a fluid's report into the summary of the run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::process {

/// Adds the content of `file` by the fluid `name` to `summary` and removes the file; nothing if there is none. The
/// program may be a user's: entries of the wrong form become warnings.
void merge_report(const std::filesystem::path& file, const std::string& name, nlohmann::json& summary);

}  // namespace blockweir::process
