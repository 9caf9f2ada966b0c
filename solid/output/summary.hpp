// SPDX-License-Identifier: GPL-3.0-or-later
// summary.json: outcome, failure or margin, checks against formulas, counts, profile.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// All of the summary but what the caller times itself (keys wall_time_s, profile_s).
nlohmann::json summary(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
