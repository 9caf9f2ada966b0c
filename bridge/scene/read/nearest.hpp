// SPDX-License-Identifier: GPL-3.0-or-later
// The right word that a wrong one was probably meant to be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blockweir::scene {

/// The candidate that takes fewest letters inserted, left out, replaced or swapped with the next; the first of equals.
/// Empty when even that takes more than half the word's letters.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// The same as a remedy: `did you mean "..."?`, or empty.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "one of a, b, c", cut short where there are many.
std::string one_of(const std::vector<std::string>& candidates);

}  // namespace blockweir::scene
