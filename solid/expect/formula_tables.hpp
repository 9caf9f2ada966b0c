// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of the formulas, and what they read from a scene.
#pragma once

#include <map>
#include <string>

#include "bridge/scene/block_facts.hpp"

namespace blockweir::solid::expect {

using scene::Point;
using scene::Scene;

/// By name. A formula gets the scene and the name of its subject, `of` in the scene.
using Formulas = std::map<std::string, double (*)(const Scene&, const std::string&)>;
const Formulas& block_formulas();     ///< blocks under their own weight
const Formulas& dam_formulas();       ///< limit equilibrium and water pressures
const Formulas& dynamics_formulas();  ///< oscillation, impact, rocking, waves
const Formulas& masonry_formulas();   ///< arches
const Formulas& motion_formulas();    ///< sliding
const Formulas& slope_formulas();     ///< toppling

/// A block on a plane joint: data for limit equilibrium.
struct PlaneJoint {
  double dip = 0;       ///< rad from the horizontal, positive downwards to the downstream side
  double length = 0;    ///< m along the trace
  double weight = 0;    ///< of the block above
  double friction = 0;  ///< tan(phi)
  double cohesion = 0;  ///< c times bonded length [N per metre]
  const scene::JointLaw* law = nullptr;
  const scene::Block* upper = nullptr;
  Point mouth;
};

/// The dip is that of the gentlest piece: a rigid block slides along its shallowest tread, and the risers open. Other
/// joints below the same block add to the length.
PlaneJoint plane_joint(const Scene& s, const std::string& name);

}  // namespace blockweir::solid::expect
