// SPDX-License-Identifier: GPL-3.0-or-later
// On which joint a body fails: where its head is measured from, and what its failure is named by.
#pragma once

#include <optional>
#include <string>

#include "bridge/geometry/point.hpp"
#include "solid/watch/moving_body.hpp"

namespace blockweir::solid {

/// The joint on which a body leaves the others.
struct FailedJoint {
  std::string name;
  std::optional<geometry::Segment> line;  ///< m, from upstream in the scene's outline; none where they did not touch
};

/// Of the joints that the body leaves, the one that begins nearest to the higher pool; where it slides, of the surface
/// that bears most. Where it turns, what has opened belongs to the joint. Blocks that had no joint count when they
/// press on each other now.
FailedJoint failed_joint(const Solid& solid, const MovingBody& body, const PairMotions& pairs, bool turns,
                         bool from_downstream);

}  // namespace blockweir::solid
