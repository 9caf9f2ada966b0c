// SPDX-License-Identifier: GPL-3.0-or-later
// What a summary says of a breach: how the water passed, and what moved only afterwards. Still water that has been let
// through would flow: what its pressures move from then on is no failure of the structure.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// Until when blocks that set out count as failed: to a breach of still water that another failure made.
double counted_until_s(const expect::Outcome& outcome);

/// Whether this failure began only after such a breach, one that another failure had made.
bool is_after_breach(const expect::Outcome& outcome, const Failure& failure);

void add_breach(const expect::Outcome& outcome, nlohmann::json& text);

}  // namespace blockweir::solid::output
