// SPDX-License-Identifier: GPL-3.0-or-later
// How much work a cut will be, before it is begun: lines may cross as often as the square of their number.
#pragma once

#include <cstddef>
#include <vector>

#include "bridge/geometry/cut.hpp"

namespace blockweir::geometry {

/// Straight parts of the section's outline, its holes and the lines.
std::size_t count_segments(const Section& section, const std::vector<Line>& lines);

/// Pairs of those parts that cross, inside or outside the section; counting ends beyond `most`. To round-off.
std::size_t count_crossings(const Section& section, const std::vector<Line>& lines, std::size_t most);

}  // namespace blockweir::geometry
