// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of a run for the report's animation.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace blockweir::picture {

/// frames, view, pictured (the frame whose pressures the section shows: the last up to the failure) and failure_s
/// (null: none). Long or large runs are thinned, evenly in time, but keep the pictured frame.
[[nodiscard]] nlohmann::json frames_data(const std::filesystem::path& run, const nlohmann::json& summary);

}  // namespace blockweir::picture
