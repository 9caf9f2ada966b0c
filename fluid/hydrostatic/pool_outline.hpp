// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of a pool's section: a walk along frame and obstacles with the water on its left.
#pragma once

#include <optional>
#include <vector>

#include "fluid/hydrostatic/sideways.hpp"

namespace blockweir::hydrostatic {

constexpr double largest_coordinate_m = 1048576;        // 2^20
constexpr double outline_unit_m = 1 / 1099511627776.0;  // 2^-40: outlines are walked in whole numbers of it

/// A ring of the outline; on[i] is what the stretch from corner i to the next lies on: an obstacle's number, or
/// `frame`.
struct OutlineRing {
  static constexpr int frame = -1;
  Ring corner;
  std::vector<int> on;
};

/// What of `frame`, four corners counter-clockwise, is connected to its left or right side once the obstacles, closed
/// lines counter-clockwise, are taken out: the outer ring, then its holes. Nothing of that side may lie in an obstacle.
/// Inside is where the obstacles' winding numbers add up to more than nothing. No value where an edge of the
/// outline touches another without crossing, or three meet in one point: then nothing tells on which side to pass, and
/// the obstacles have to be moved a little. Else the answer is exact but for the place of crossings, which is rounded.
/// Coordinates are not above `largest_coordinate_m`.
enum class FrameSide { left, right };
std::optional<std::vector<OutlineRing>> pool_outline(const Ring& frame, FrameSide side,
                                                     const std::vector<Ring>& obstacles);

}  // namespace blockweir::hydrostatic
