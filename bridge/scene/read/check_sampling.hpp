// SPDX-License-Identifier: GPL-3.0-or-later
// What a run that looks at a course in time now and then does not see of it.
#pragma once

#include <string>

#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/time_table.hpp"

namespace blockweir::scene {

/// How a run looks at a course in time.
struct Sampling {
  const char* key;  ///< that sets `every_s`
  double every_s;
  double duration_s;
  bool rows_are_seen = false;  ///< between two looks it takes the rows' mean, or looks at rows, too
};

/// Warns of a sine with fewer than ten looks a period. A row that is higher or lower than what is seen before and after
/// it is an error.
void check_sampling(const std::string& name, const Place& place, const TimeTable& course, const Sampling& sampling,
                    Problems& problems);

}  // namespace blockweir::scene
