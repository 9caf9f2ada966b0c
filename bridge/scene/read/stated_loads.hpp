// SPDX-License-Identifier: GPL-3.0-or-later
// Which loads a scene states beside weight and water, as its file calls them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace blockweir::scene {

/// The tables of loads in a scene's text: "[silt]", "[[point_load]]", ... The text is one that has been read.
std::vector<std::string> stated_loads(const std::string& text);

/// Up to which [silt] lies in such a text [m]; none without it.
std::optional<double> silt_level_m(const std::string& text);

}  // namespace blockweir::scene
