// SPDX-License-Identifier: GPL-3.0-or-later
// Meshed blocks against a reservoir that answers their mean motion alone.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// What a wet block with a mesh lacks of its water. Empty where the water answers nothing, or no such block moves.
std::string mesh_in_reservoir_warning(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
