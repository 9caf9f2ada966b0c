// SPDX-License-Identifier: GPL-3.0-or-later
// What a fluid says of its own work, in the summary of the run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace blockweir::process {

/// Adds what `file` says to `summary` and removes the file; nothing where there is none. The program may be a user's:
/// what is of another form than it should be becomes a warning.
void merge_report(const std::filesystem::path& file, nlohmann::json& summary);

}  // namespace blockweir::process
