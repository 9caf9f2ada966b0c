// SPDX-License-Identifier: GPL-3.0-or-later
// The level at which the blocks themselves lose their equilibrium: static analysis under a level that rises, with the
// scene's own contact laws and the memory of their joints; where one level finds no rest, the rise to it is halved.
// Then the same without that memory: all loads at once.
#pragma once

#include <optional>
#include <string>

#include "solid/capacity/still_water.hpp"
#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {

struct StaticLevel {
  limit::Filled outcome = limit::Filled::does_not_stand_empty;
  double level_m = 0;               ///< where it fails, the middle of the bracket; else that of the full reservoir
  double width_m = 0;               ///< of the bracket
  std::optional<Failure> failure;   ///< how; none where that was not seen
  bool slips_add_up = false;        ///< that is of many slips: no unbroken motion was seen
  std::optional<double> settles_m;  ///< the lowest level at which blocks slip a little and then rest, if there is one
  std::string stopped;              ///< why the bracket is no narrower; empty where it is as narrow as it is to be
  std::string warning;              ///< of the blocks at the highest level at which they rest; empty: none
  /// What a level that rises slowly comes to, where a lower one fails with all loads at once; level_m is then that one.
  struct SlowRise {
    limit::Filled outcome;
    double level_m;
  };
  std::optional<SlowRise> slow_rise;
};

/// `width`: of the bracket at the end, over the rise from the empty reservoir; coarser where blocks settle on the way.
/// `suspect_m`: a level below which the blocks are looked at with all loads at once, too.
/// Throws TookTooLong when the time is over before there is one, std::runtime_error where no equilibrium is found and
/// no block goes far: that is no failure.
StaticLevel static_level(const scene::Scene& scene, StillWater& water, double width = 1e-10,
                         std::optional<double> suspect_m = std::nullopt);

}  // namespace blockweir::solid
