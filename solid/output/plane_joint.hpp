// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a scene as limit equilibrium sees them: blocks with weights, on plane joints with a dip.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid::output {

/// Throw std::runtime_error when the scene has no such thing.
const scene::Block& block_named(const scene::Scene& scene, const std::string& name);
const scene::Joint& joint_named(const scene::Scene& scene, const std::string& name);

/// N per metre.
double weight(const scene::Scene& scene, const scene::Block& block);

/// A block on a plane joint.
struct PlaneJoint {
  double dip = 0;       ///< rad against the level, positive downwards to the downstream side
  double length = 0;    ///< m along the trace
  double weight = 0;    ///< of the block above
  double friction = 0;  ///< tan(phi)
  double cohesion = 0;  ///< c times bonded length [N per metre]
  double uplift = 0;    ///< k: 0 dry, 1/2 triangular, 1 full
  const scene::Block* upper = nullptr;
  scene::Point mouth;
};

/// The dip is that of the gentlest piece: a rigid block slides along its shallowest tread and the risers open. Other
/// joints that the same block stands on lengthen the crack.
PlaneJoint plane_joint(const scene::Scene& scene, const std::string& name);

}  // namespace blockweir::solid::output
