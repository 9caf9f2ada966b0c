// SPDX-License-Identifier: GPL-3.0-or-later
// How far a run came that could not write its summary.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace blockweir::process {

/// From the last whole row of history.csv: time_s, level_m (null without a reservoir) and both in words as text. Null
/// where there is no row.
nlohmann::json reached(const std::filesystem::path& run);

}  // namespace blockweir::process
