// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a mechanism of limit analysis: the blocks as drawn, and displaced along their first motion.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// `mechanism`: from the answer of `blockweir-limit`; `level_m`: of the reservoir, if there is one. Throws
/// std::runtime_error if gnuplot is missing.
void draw_mechanism(const scene::Scene& scene, const nlohmann::json& mechanism, const std::optional<double>& level_m,
                    const std::filesystem::path& out);

}  // namespace blockweir::picture
