// SPDX-License-Identifier: GPL-3.0-or-later
// Strength reduction with the blocks: the factor by which c and tan(phi) of all joints can be divided until a static
// analysis finds no rest. It is below 1 if the scene as stated finds none.
#pragma once

#include <optional>
#include <string>

#include "solid/capacity/still_water.hpp"
#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid {

/// Divides c and tan(phi), peak and residual, of all joints by `reduction`.
scene::Scene with_reduced_strength(scene::Scene scene, double reduction);

/// Whether the scene as stated is stable, by one analysis from the geometry as drawn. Throws as static_strength does,
/// and Undecided.
bool stands(const scene::Scene& scene, StillWater* water, double level_m);

struct StaticStrength {
  limit::Bearing bearing = limit::Bearing::bears_none;  ///< as in limit::LimitStrength
  double factor = 0;       ///< the middle of the bracket; its lower end if the time was over
  double width = 0;        ///< of the bracket
  bool creeps = false;     ///< an analysis near the factor was given up and counts as a failure
  bool by_motion = false;  ///< static analyses were given up: the blocks came to rest, or failed, when they were let go
  std::string moving;      ///< if it bears none: the block that moves most in the last analysis
  std::string stopped;     ///< why the bracket is not narrower; empty if it is narrow enough
};

/// Each reduction is a separate analysis from the scene as drawn. `guess`: start of the search. `water`: null if
/// there is none; otherwise `level_m` is the reservoir's level. `jumps_below`: below this factor the result depends
/// on the history of the joint forces and jumps by per cents; there it is found to 1e-4 only. Where static analyses do
/// not get to an end there it is that of ReleasedBlocks, to 1e-2. If no joint has shear strength, one analysis tells
/// whether the blocks bear every reduction or none. Throws TookTooLong if the time is over before there is a bracket,
/// and std::runtime_error with the reason if no strength gives equations that can be solved.
StaticStrength static_strength(const scene::Scene& scene, StillWater* water, double level_m, double guess,
                               std::optional<double> jumps_below = {});

}  // namespace blockweir::solid
