// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates the work of a cut before it starts: the number of crossings may grow with the square of the lines.
#pragma once

#include <cstddef>
#include <vector>

#include "bridge/geometry/cut.hpp"

namespace blockweir::geometry {

/// Number of straight segments of the section's outline, its holes and the lines.
std::size_t count_segments(const Section& section, const std::vector<Line>& lines);

/// Number of crossing pairs of these segments, inside or outside the section, to round-off. Stops counting at `most`.
std::size_t count_crossings(const Section& section, const std::vector<Line>& lines, std::size_t most);

}  // namespace blockweir::geometry
