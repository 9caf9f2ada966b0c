// SPDX-License-Identifier: GPL-3.0-or-later
// The level at which the blocks lose equilibrium, by static analyses under a rising level, with the scene's contact
// laws and the history of the joints. Where a level finds no rest, the rise to it is halved. Then the same without
// history: all loads at once.
#pragma once

#include <optional>
#include <string>

#include "solid/capacity/still_water.hpp"
#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {

struct StaticLevel {
  limit::Filled outcome = limit::Filled::does_not_stand_empty;
  double level_m = 0;                 ///< at failure, the middle of the bracket; without failure, the full reservoir
  double width_m = 0;                 ///< of the bracket
  std::optional<Failure> failure;     ///< none if the mode was not found
  bool slips_add_up = false;          ///< failure by the sum of many slips: no continuous motion was found
  std::optional<double> settles_m;    ///< the lowest level, if any, at which blocks slip a little and come to rest
  std::string stopped;                ///< why the bracket is not narrower; empty if it is narrow enough
  std::vector<std::string> warnings;  ///< about the blocks at the highest level at which they rest
  /// Result of a slowly rising level, where a lower level fails with all loads at once; level_m is the lower one.
  struct SlowRise {
    limit::Filled outcome;
    double level_m;
  };
  std::optional<SlowRise> slow_rise;
};

/// What limit analysis or blocks without strain have said before.
struct LevelClues {
  std::optional<double> limit_m;              ///< level of failure by limit analysis
  std::optional<double> suspect_m;            ///< a level below which all loads are also tried at once
  const char* whose = "level by the blocks";  ///< name of the search in lines of progress
  bool falls_as_drawn = false;  ///< limit analysis has a mechanism under the empty reservoir: see most_systems
};

/// `width`: of the final bracket, over the rise from the empty reservoir; wider where blocks settle before failure.
/// Throws TookTooLong if the time is over before
/// there is a bracket. Throws std::runtime_error if no equilibrium is found although no block moves far: that is not a
/// failure.
StaticLevel static_level(const scene::Scene& scene, StillWater& water, double width = 1e-10,
                         const LevelClues& clues = {});

}  // namespace blockweir::solid
