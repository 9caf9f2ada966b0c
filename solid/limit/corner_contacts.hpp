// SPDX-License-Identifier: GPL-3.0-or-later
// Points where a corner of one block touches another, besides their common faces.
#pragma once

#include <vector>

#include "bridge/scene/joint_trace.hpp"
#include "solid/limit/twist.hpp"

namespace blockweir::solid::limit {

struct CornerContact {
  Point at_m;
  Point normal;  ///< out of the block
  bool in_kink;  ///< in a reflex corner of the other block
};

/// A neighbour of the block. `trace`: their common boundary, where `block` is the second of the two.
struct Neighbour {
  int index = 0;
  const scene::Block* block = nullptr;
  scene::JointTrace trace;
};

/// Contacts of corners with edges, or with a reflex corner of a body, which holds a corner by both its edges. No
/// contact where a face along the edge reaches the corner, since the face holds it. Two convex corners give no contact:
/// they may pass on either side. `body`: a block, or all ground blocks together, since two of them can form a reflex
/// corner. Returns the contacts that involve `neighbour`, a block of the body.
std::vector<CornerContact> corner_contacts(const scene::Block& block, const std::vector<Neighbour>& body,
                                           const Neighbour& neighbour, double touching_m);

}  // namespace blockweir::solid::limit
