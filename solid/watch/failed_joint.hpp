// SPDX-License-Identifier: GPL-3.0-or-later
// The joint on which a body fails: it names the failure, and the head is measured from it.
#pragma once

#include <optional>
#include <string>

#include "bridge/geometry/point.hpp"
#include "solid/watch/moving_body.hpp"

namespace blockweir::solid {

/// The joint on which a body separates from the others.
struct FailedJoint {
  std::string name;
  std::string turns_on;                   ///< the joint that bears while the named one opens; empty if that bears
  std::optional<geometry::Segment> line;  ///< m, from upstream, as drawn; none if the blocks did not touch
};

/// Of the joints on which the body separates, the one that starts nearest to the higher pool; for sliding, on the
/// surface that carries most, to the very end of the plane. For rotation, open joints count, too. Blocks without a
/// joint count if they press on each other now.
FailedJoint failed_joint(const Solid& solid, const MovingBody& body, const PairMotions& pairs, bool turns,
                         bool from_downstream);

}  // namespace blockweir::solid
