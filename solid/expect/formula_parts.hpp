// SPDX-License-Identifier: GPL-3.0-or-later
// What the formulas have in common: tables of them, and what they read from a scene.
#pragma once

#include <map>
#include <string>

#include "bridge/scene/block_facts.hpp"

namespace blockweir::solid::expect {

using scene::Point;
using scene::Scene;

/// By name; each gets the scene and what the expectation is `of`.
using Formulas = std::map<std::string, double (*)(const Scene&, const std::string&)>;
const Formulas& block_formulas();     ///< under their own weight
const Formulas& dam_formulas();       ///< limit equilibrium and pressures of water
const Formulas& dynamics_formulas();  ///< oscillation, impact, rocking, waves
const Formulas& masonry_formulas();   ///< arches
const Formulas& motion_formulas();    ///< sliding
const Formulas& slope_formulas();     ///< toppling

/// A block on a plane joint: what limit equilibrium needs.
struct PlaneJoint {
  double dip = 0;       ///< rad against the level, positive downwards to the downstream side
  double length = 0;    ///< m along the trace
  double weight = 0;    ///< of the block above
  double friction = 0;  ///< tan(phi)
  double cohesion = 0;  ///< c times bonded length [N per metre]
  const scene::JointLaw* law = nullptr;
  const scene::Block* upper = nullptr;
  Point mouth;
};

/// The dip is that of the gentlest piece: a rigid block slides along its shallowest tread and the risers open. Other
/// joints that the same block stands on lengthen the crack.
PlaneJoint plane_joint(const Scene& s, const std::string& name);

}  // namespace blockweir::solid::expect
