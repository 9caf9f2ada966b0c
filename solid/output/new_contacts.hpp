// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that have met on their way: what law holds between them.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// Of pairs that touch at the run's end, but not at its start, and have the law of [joint] though one of them has a
/// joint with another friction. Empty where there are none.
std::string new_contacts_warning(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
