// SPDX-License-Identifier: GPL-3.0-or-later
// The stored frames of a run, and the part of the section that their pictures show.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// The frames of frames.jsonl. Throws std::invalid_argument if there are none.
[[nodiscard]] std::vector<nlohmann::json> read_frames(const std::filesystem::path& run);

/// A view of everything that moves in any frame, with some ground below and water beside it, and of fixed walls that
/// are higher than `water_m`.
[[nodiscard]] View view_of(const std::vector<nlohmann::json>& frames, double water_m);

/// How many of the blocks that can move are not wholly in the view: what is thrown far would leave the structure a dot.
[[nodiscard]] std::size_t blocks_beyond(const nlohmann::json& frame, const View& view);

}  // namespace blockweir::picture
