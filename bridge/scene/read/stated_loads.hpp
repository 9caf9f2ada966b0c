// SPDX-License-Identifier: GPL-3.0-or-later
// Loads that a scene states besides weight and water, by the names of their tables.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// The load tables of a scene that act at the end of its run: "[silt]", "[[point_load]]", ... Where the ground has come
/// to rest by then, "[base_motion]" is not among them.
std::vector<std::string> stated_loads(const Scene& scene);

/// The numbers of [silt], [ice] and [earthquake] in the text of a valid scene, by keys as --set takes them:
/// "silt.level_m".
std::map<std::string, double> silt_ice_and_earthquake(const std::string& text);

/// Elevation of the top of [silt] in such a text [m]; none without silt.
std::optional<double> silt_level_m(const std::string& text);

}  // namespace blockweir::scene
