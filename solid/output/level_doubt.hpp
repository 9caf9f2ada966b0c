// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader has to know of the level of a failure.
#pragma once

#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid::output {

/// Limits of the level's accuracy, and what finds a better one; empty if it is that of slow filling to a thousandth of
/// the head.
std::string level_doubt(const scene::Scene& scene, const Failure& failure);

}  // namespace blockweir::solid::output
