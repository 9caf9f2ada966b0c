// SPDX-License-Identifier: GPL-3.0-or-later
// The right word that a wrong one was probably meant to be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blockweir::scene {

/// The candidate with the smallest edit distance; empty when none is closer than half the word's length.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace blockweir::scene
