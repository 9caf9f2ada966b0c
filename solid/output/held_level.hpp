// SPDX-License-Identifier: GPL-3.0-or-later
// Warns that OpenFOAM's water was given its level while what held it went away.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// Empty unless blocks that failed moved on, in water whose levels are set in every window.
std::string held_level_warning(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
