// SPDX-License-Identifier: GPL-3.0-or-later
// summary.json: outcome, failure or margin, checks against formulas, counts, profile.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// The summary except the parts that the caller times (keys wall_time_s, profile_s).
nlohmann::json summary(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
