// SPDX-License-Identifier: GPL-3.0-or-later
// The tension that a joint bears by its law.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Pa. Mohr-Coulomb's |shear| <= c + sigma tan(phi) ends at the tension c/tan(phi): what a law states beyond it counts
/// as that, else a joint would bear shear under a tension at which it has no strength left.
inline double tension_cut_off_pa(const JointLaw& law) {
  const double friction = std::tan(law.friction_angle_deg * std::numbers::pi / 180);
  return friction > 0 ? std::min(law.tension_strength_pa, law.cohesion_pa / friction) : law.tension_strength_pa;
}

}  // namespace blockweir::scene
