// SPDX-License-Identifier: GPL-3.0-or-later
// Warns about corners that bear a force where two blocks only meet in a point.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// Of what stands where it was drawn, at the run's end: names the corner that bears most, if that is more than a
/// thousandth of the weight. Empty if there is none. Limit analysis knows no such force.
std::string pressing_corners_warning(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
