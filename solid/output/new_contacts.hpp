// SPDX-License-Identifier: GPL-3.0-or-later
// Warns about the joint law between blocks that came into contact during the run.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// For pairs that touch at the run's end but not at its start, and have the law of [joint] although one of the blocks
/// has a joint with another friction. Empty if there are none.
std::string new_contacts_warning(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
