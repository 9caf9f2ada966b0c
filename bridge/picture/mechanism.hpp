// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism of limit analysis: blocks where they are drawn, and displaced as they would begin to move.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// `mechanism` as `blockweir-limit` answers it; `level_m` of the reservoir, where there is one. Throws
/// std::runtime_error when gnuplot is missing.
void draw_mechanism(const scene::Scene& scene, const nlohmann::json& mechanism, const std::optional<double>& level_m,
                    const std::filesystem::path& out);

}  // namespace blockweir::picture
