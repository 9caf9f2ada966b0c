// SPDX-License-Identifier: GPL-3.0-or-later
// What a fluid says of its own work, in the summary of the run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::process {

/// Adds what `file` of the fluid (`name`, for messages) says to `summary` and removes the file; nothing where there is
/// none. The program may be a user's: what is of another form than it should be becomes a warning.
void merge_report(const std::filesystem::path& file, const std::string& name, nlohmann::json& summary);

}  // namespace blockweir::process
