// SPDX-License-Identifier: GPL-3.0-or-later
// A section with all that acts on it at one moment or in one load case, ready to be drawn.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// acting (with diagrams), legend, bolts (with their label), upstream and downstream level (m or null), pools, view and
/// time_s. `water` is the answer to the question "water"; `bolt_forces` a force a bolt (N/m), or empty: the prestress.
[[nodiscard]] nlohmann::json section_state(const scene::Scene& scene, const nlohmann::json& water, double time_s,
                                           const nlohmann::json& bolt_forces);

}  // namespace blockweir::picture
