// SPDX-License-Identifier: GPL-3.0-or-later
// The time histories of a report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace blockweir::picture {

/// time, and groups of curves with title and unit: levels, motions of the blocks that move most, forces of the joints
/// that slip most. left_out names those not shown.
[[nodiscard]] nlohmann::json histories_data(const std::filesystem::path& run);

}  // namespace blockweir::picture
