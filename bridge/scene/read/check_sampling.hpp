// SPDX-License-Identifier: GPL-3.0-or-later
// Warns where a run evaluates a time table too rarely to see its peaks.
#pragma once

#include <string>

#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/time_table.hpp"

namespace blockweir::scene {

/// How often a run evaluates a time table.
struct Sampling {
  const char* key;  ///< that sets `every_s`
  double every_s;
  double duration_s;
  bool rows_are_seen = false;  ///< the run also uses the mean of the rows between two times, or the rows themselves
};

/// Warns of a sine with fewer than ten evaluations a period. Reports as an error a row that is higher or lower than the
/// values before and after it that the run sees.
void check_sampling(const std::string& name, const Place& place, const TimeTable& course, const Sampling& sampling,
                    Problems& problems);

}  // namespace blockweir::scene
