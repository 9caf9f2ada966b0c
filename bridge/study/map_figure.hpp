// SPDX-License-Identifier: GPL-3.0-or-later
// A map of outcomes as a picture and as letters.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::study {

/// Letter for a cell's word, in text.
char letter(const std::string& word);

/// gnuplot's colour for a cell's word.
std::string colour(const std::string& word);

/// Beside the letter of a cell that is not as expected.
constexpr char wrong_mark = '!';

/// One line with the letters and words that occur in the cells.
std::string legend(const nlohmann::json& cells);

/// gnuplot's commands: one square for each cell in the colour of its word, with its error if there is one and a red
/// cross if it is wrong. Values are drawn at equal distances in their order.
std::string map_figure(const std::array<scene::Sweep, 2>& axes, const nlohmann::json& cells);

}  // namespace blockweir::study
