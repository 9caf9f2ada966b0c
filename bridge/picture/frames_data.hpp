// SPDX-License-Identifier: GPL-3.0-or-later
// The moments of a run that a report plays.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace blockweir::picture {

/// frames, view, pictured (the frame of the section's pressures) and failure_s (null: none). Long runs and large ones
/// are thinned, evenly in time.
[[nodiscard]] nlohmann::json frames_data(const std::filesystem::path& run, const nlohmann::json& summary);

}  // namespace blockweir::picture
