// SPDX-License-Identifier: GPL-3.0-or-later
// Lines along which joints lie in the scene as drawn.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Blocks that touch, the lower index first.
using BlockPair = std::pair<int, int>;
using JointPoints = std::map<BlockPair, std::vector<Point>>;

/// Does a contact's vertex lie on its edge in the scene as drawn?
bool lies_on_joint(const Solid& solid, const ContactPoint& c);
/// Outline points of each joint: vertices that lie on an edge of the other block there, whether they press on it now or
/// not.
JointPoints joint_points(const Solid& solid);
/// Whether a joint's points have one place, or lie on one line.
bool is_point(const Solid& solid, const std::vector<Point>& points);
bool is_straight(const Solid& solid, const std::vector<Point>& points);
/// Joints that lie in one line, two or more.
std::vector<std::set<BlockPair>> in_one_line(const Solid& solid, const JointPoints& points);
/// Joints in one line, apart where a gap is wider than a joint beside it and no block spans it: the springings of an
/// arch have no common resultant.
std::vector<std::set<BlockPair>> parted_by_gaps(const Solid& solid, const JointPoints& points,
                                                const std::set<BlockPair>& line);

}  // namespace blockweir::solid
