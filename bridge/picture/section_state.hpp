// SPDX-License-Identifier: GPL-3.0-or-later
// A section with all its loads, at one moment or in one load case, ready to be drawn.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// acting (with diagrams), legend, bolts (with label), upstream and downstream level (m or null), pools, view, time_s.
/// `water`: the answer to the question "water"; `bolt_forces`: one for each bolt (N/m), or empty: the prestress.
[[nodiscard]] nlohmann::json section_state(const scene::Scene& scene, const nlohmann::json& water, double time_s,
                                           const nlohmann::json& bolt_forces);

}  // namespace blockweir::picture
