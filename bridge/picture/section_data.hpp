// SPDX-License-Identifier: GPL-3.0-or-later
// The section of a report: blocks, joints, dimensions and bolts as stated in the scene.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// blocks, joints, laws, materials, bolts, dimensions and size_m.
[[nodiscard]] nlohmann::json section_data(const scene::Scene& scene);

}  // namespace blockweir::picture
