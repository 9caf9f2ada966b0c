// SPDX-License-Identifier: GPL-3.0-or-later
// Large problems in parts that threads sweep side by side: rows of different parts share no body. What joins parts is
// swept after them. The parts are the same for any number of threads, and so are the bits.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace blockweir::solid {

constexpr int sweep_parts = 4;

/// Where each part ends among what is visited, and what joins them: that of a small problem is all in the first.
using EndsOfParts = std::array<std::size_t, sweep_parts + 1>;

/// Of each row the part that its bodies are in, or sweep_parts where it joins two; empty where few rows are one part.
/// `bodies`: of both
/// ends of each, below body_numbers; negative: what does not move. Parts hold like numbers of bodies, in an order in
/// which neighbours follow each other.
[[nodiscard]] std::vector<int> parts_of_rows(std::span<const std::array<int, 2>> bodies, std::size_t body_numbers);

}  // namespace blockweir::solid
