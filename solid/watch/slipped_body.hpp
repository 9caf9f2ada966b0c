// SPDX-License-Identifier: GPL-3.0-or-later
// The failure of blocks that come to rest after each slip, while their slips add up.
#pragma once

#include <optional>

#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {

/// The body of the block that has slipped most since the scene as drawn, with its joint and the reservoir's level; none
/// if no contact has slipped.
std::optional<Failure> slipped_body(const Solid& solid, double level_m);

}  // namespace blockweir::solid
