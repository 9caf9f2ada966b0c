// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines as contacts see them: a joint that is straight but for rounded coordinates is straight.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/block/block.hpp"

namespace blockweir::solid {

/// A straight side: the part that it belongs to, and its ends as material points of that part. It begins on an edge of
/// the scene's block, at these fractions of it.
struct ContactSide {
  int part = 0;
  int described_edge = 0;
  double s_from = 0;
  double s_to = 1;
  Point from;
  Point to;
};
using ContactOutline = std::vector<ContactSide>;

/// Of the scene's blocks; of one with a mesh its empty outline. `blocks`: those of the scene as they move.
///
/// Between two blocks that touch, vertices of both are left out where the joint bends by less than 0.01 rad from its
/// chord. Rigid faces with such bends would part where they slip by round-off, their bonds would break there, and
/// redundant contacts would contradict each other.
std::vector<ContactOutline> contact_outlines(const scene::Scene& scene, const std::vector<Block>& blocks);

}  // namespace blockweir::solid
