// SPDX-License-Identifier: GPL-3.0-or-later
// Points in which a corner of one block meets another one, beside the faces that the two have in common.
#pragma once

#include <vector>

#include "bridge/scene/joint_trace.hpp"
#include "solid/limit/twist.hpp"

namespace blockweir::solid::limit {

struct CornerContact {
  Point at_m;
  Point normal;  ///< out of block a
  bool in_kink;  ///< in a reflex corner of the other block
};

/// A corner on an edge, or in a reflex corner of the other block, which holds it by both of its edges. Not where a face
/// of the trace along that edge reaches the corner: the face holds it there. Two convex corners that meet hold nothing:
/// they may pass on either side.
std::vector<CornerContact> corner_contacts(const scene::Block& a, const scene::Block& b, const scene::JointTrace& trace,
                                           double touching_m);

}  // namespace blockweir::solid::limit
