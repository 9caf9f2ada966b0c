// SPDX-License-Identifier: GPL-3.0-or-later
// Strength reduction by the blocks themselves: the factor by which c and tan(phi) of all joints can be divided until
// static analysis finds no rest; below 1 where it finds none as the scene stands.
#pragma once

#include <optional>
#include <string>

#include "solid/capacity/still_water.hpp"
#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid {

/// c and tan(phi), peak and residual, of all joints divided by that.
scene::Scene with_reduced_strength(scene::Scene scene, double reduction);

/// As the scene is, by one analysis from its outline. Throws as static_strength does.
bool stands(const scene::Scene& scene, StillWater* water, double level_m);

struct StaticStrength {
  limit::Bearing bearing = limit::Bearing::bears_none;  ///< as in limit::LimitStrength
  double factor = 0;    ///< the middle of the bracket; its lower end where the time was over
  double width = 0;     ///< of the bracket
  bool creeps = false;  ///< an analysis near the bound was given up, and counts as one that fails
  std::string moving;   ///< where it bears none: the block that moves most in the last analysis
  std::string stopped;  ///< why it is no narrower; empty where it is as narrow as it is to be
};

/// Each reduction is an analysis of its own, from the scene's outline. `guess`: where the search begins. `water`: null
/// where there is none; else `level_m` is the reservoir's. `jumps_below`: a factor below that depends on how the
/// joints' forces came about, and jumps by per cents as anything changes; it is found to 1e-4 alone. Where no joint has
/// a shear strength, one analysis says whether the blocks bear any reduction or none. Throws TookTooLong when the time
/// is over before a bracket is found, and std::runtime_error with the reason where no strength gives equations that can
/// be solved.
StaticStrength static_strength(const scene::Scene& scene, StillWater* water, double level_m, double guess,
                               std::optional<double> jumps_below = {});

}  // namespace blockweir::solid
