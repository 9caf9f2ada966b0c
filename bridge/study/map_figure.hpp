// SPDX-License-Identifier: GPL-3.0-or-later
// A map as a picture and as letters.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::study {

/// Of a cell's word in text.
char letter(const std::string& word);

/// gnuplot's, of a cell's word.
std::string colour(const std::string& word);

/// Letters and words that the cells have, a line.
std::string legend(const nlohmann::json& cells);

/// gnuplot's commands: a square a cell in the colour of its word, with its error where there is one, a red cross on
/// wrong ones. Values stand side by side in their order, whatever their distance.
std::string map_figure(const std::array<scene::Sweep, 2>& axes, const nlohmann::json& cells);

}  // namespace blockweir::study
