// SPDX-License-Identifier: GPL-3.0-or-later
// What has failed where blocks come to rest again each time, and their slips add up to a failure.
#pragma once

#include <optional>

#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {

/// The body of the block that has slipped most since the scene's outline, on its joint, at the reservoir's level; none
/// where no contact has slipped.
std::optional<Failure> slipped_body(const Solid& solid, double level_m);

}  // namespace blockweir::solid
