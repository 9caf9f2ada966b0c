// SPDX-License-Identifier: GPL-3.0-or-later
// Loads that a scene states besides weight and water, by the names of their tables.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace blockweir::scene {

/// The load tables in a scene's text: "[silt]", "[[point_load]]", ... The text must be that of a valid scene.
std::vector<std::string> stated_loads(const std::string& text);

/// The numbers of [silt], [ice] and [earthquake] in such a text, by keys as --set takes them: "silt.level_m".
std::map<std::string, double> silt_ice_and_earthquake(const std::string& text);

/// Elevation of the top of [silt] in such a text [m]; none without silt.
std::optional<double> silt_level_m(const std::string& text);

}  // namespace blockweir::scene
