// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict of a run: stands, fails, moving or stopped, with the failure or the margins, as numbers and as text.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// Adds keys outcome, failure or margin, moving, stopped, rest, breach and loose to a summary, and its warnings.
void add_verdict(const expect::Outcome& outcome, nlohmann::json& summary);

}  // namespace blockweir::solid::output
