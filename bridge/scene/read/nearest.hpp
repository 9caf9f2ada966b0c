// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the known word closest to a misspelt one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blockweir::scene {

/// The candidate that needs the fewest letters inserted, removed, replaced or swapped with the next; the first of
/// equals. Empty if even that changes more than half of the word's letters.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// The same as a remedy: `did you mean "..."?`, or empty.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "one of a, b, c", shortened if there are many.
std::string one_of(const std::vector<std::string>& candidates);

}  // namespace blockweir::scene
