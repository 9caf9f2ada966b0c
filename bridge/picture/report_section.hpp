// SPDX-License-Identifier: GPL-3.0-or-later
// The section of a report: blocks, joints, dimensions and loads as the scene states them.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// blocks, joints, laws, materials, loads, dimensions and size_m. Loads are those of time 0.
[[nodiscard]] nlohmann::json section_data(const scene::Scene& scene);

}  // namespace blockweir::picture
