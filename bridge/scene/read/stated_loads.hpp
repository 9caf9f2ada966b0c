// SPDX-License-Identifier: GPL-3.0-or-later
// Which loads a scene states beside weight and water, as its file calls them.
#pragma once

#include <string>
#include <vector>

namespace blockweir::scene {

/// The tables of loads in a scene's text: "[silt]", "[[point_load]]", ... The text is one that has been read.
std::vector<std::string> stated_loads(const std::string& text);

/// How many tables of this name the text has.
std::size_t count_tables(const std::string& text, const std::string& name);

}  // namespace blockweir::scene
