// SPDX-License-Identifier: GPL-3.0-or-later
// How far two outlines are in each other, by themselves: no contact tells it of corners that it has missed.
#pragma once

#include <vector>

#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// The farthest that a corner of one, or the middle of what of a side is inside the other, lies from the other's sides
/// [m]. `known_m` if it is no more than that.
[[nodiscard]] double overlap_m(const std::vector<Point>& a, const std::vector<Point>& b, double known_m);

/// The least shift that parts two convex outlines [m]: a tip in a block's foot is near its sole, and yet deep in it. Of
/// others, how far they overlap. `known_m` if it is no more than that.
[[nodiscard]] double parting_shift_m(const std::vector<Point>& a, const std::vector<Point>& b, double known_m);

}  // namespace blockweir::solid
