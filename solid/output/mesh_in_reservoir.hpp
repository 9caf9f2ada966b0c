// SPDX-License-Identifier: GPL-3.0-or-later
// Checks meshed blocks in a reservoir that responds to their mean motion only.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// Says what the water of a wet meshed block lacks. Empty if the water does not respond, or no such block moves.
std::string mesh_in_reservoir_warning(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
