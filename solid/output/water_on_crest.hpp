// SPDX-License-Identifier: GPL-3.0-or-later
// Still water above a crest: what stands on the crest is left out where one pool alone is above it.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// Empty where no level that decided, that of the failure or else the highest, was above the crest.
std::string water_on_crest_warning(const expect::Outcome& outcome);
/// Likewise of the scene's still water that rises to this level, the tailwater as at the end.
std::string water_on_crest_warning(const scene::Scene& scene, double level_m);

}  // namespace blockweir::solid::output
