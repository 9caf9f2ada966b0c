// SPDX-License-Identifier: GPL-3.0-or-later
// The stored moments of a run, and what of the section a picture of them shows.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// frames.jsonl, a moment each. Throws std::invalid_argument where there is none.
[[nodiscard]] std::vector<nlohmann::json> read_frames(const std::filesystem::path& run);

/// Around what moves, in all frames, with some ground below and some water beside it; and around fixed walls that stand
/// higher than `water_m`.
[[nodiscard]] View view_of(const std::vector<nlohmann::json>& frames, double water_m);

}  // namespace blockweir::picture
