// SPDX-License-Identifier: GPL-3.0-or-later
// Points in which a corner of one block meets another one, beside the faces that the two have in common.
#pragma once

#include <vector>

#include "bridge/scene/joint_trace.hpp"
#include "solid/limit/twist.hpp"

namespace blockweir::solid::limit {

struct CornerContact {
  Point at_m;
  Point normal;  ///< out of the block
  bool in_kink;  ///< in a reflex corner of the other
};

/// What a block meets. `trace`: their common boundary, `block` its second.
struct Neighbour {
  int index = 0;
  const scene::Block* block = nullptr;
  scene::JointTrace trace;
};

/// A corner on an edge, or in a reflex corner of a body, which holds it by both of its edges. Not where a face along
/// that edge reaches the corner: the face holds it there. Two convex corners that meet hold nothing: they may pass on
/// either side. `body`: a block, or all blocks of the ground, which move as one, so that two of them form a reflex
/// corner as one alone does. Of those contacts the ones with `of`, which is in it.
std::vector<CornerContact> corner_contacts(const scene::Block& block, const std::vector<Neighbour>& body,
                                           const Neighbour& of, double touching_m);

}  // namespace blockweir::solid::limit
