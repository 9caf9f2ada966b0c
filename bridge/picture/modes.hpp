// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of natural modes, beside each other.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// The six lowest of those with water, where there is any, else without. `answer` is modes_answer's. Throws
/// std::runtime_error when gnuplot is missing.
void draw_modes(const scene::Scene& scene, const nlohmann::json& answer, const std::filesystem::path& out);

}  // namespace blockweir::picture
