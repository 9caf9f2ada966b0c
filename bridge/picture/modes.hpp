// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the shapes of natural modes side by side.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// The six lowest modes, with water if there is any. `answer` is that of modes_answer. Throws std::runtime_error if
/// gnuplot is missing.
void draw_modes(const scene::Scene& scene, const nlohmann::json& answer, const std::filesystem::path& out);

}  // namespace blockweir::picture
