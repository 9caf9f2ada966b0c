// SPDX-License-Identifier: GPL-3.0-or-later
// Warns that still water above the crest does not press on it if one pool only is above it.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// Empty unless the decisive level, at failure or else the highest, was above the crest.
std::string water_on_crest_warning(const expect::Outcome& outcome);
/// The same for still water of the scene at this level, with the tailwater of the run's end.
std::string water_on_crest_warning(const scene::Scene& scene, double level_m);

}  // namespace blockweir::solid::output
