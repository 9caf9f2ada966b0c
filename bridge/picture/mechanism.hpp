// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a mechanism of limit analysis: the blocks as drawn, and displaced along their first motion.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// Of its picture, for gnuplot: what moves, and that dilation lifts it.
std::string mechanism_title(const nlohmann::json& mechanism);

/// What the drawing shows: the structure without its wide rock, all blocks that move, and a third of their size around
/// them.
[[nodiscard]] geometry::Bounds mechanism_view(const scene::Scene& scene, const nlohmann::json& mechanism);

/// `mechanism`: from the answer of `blockweir-limit`; `level_m`: of the reservoir, if there is one. Throws
/// std::runtime_error if gnuplot is missing.
void draw_mechanism(const scene::Scene& scene, const nlohmann::json& mechanism, const std::optional<double>& level_m,
                    const std::filesystem::path& out);

}  // namespace blockweir::picture
