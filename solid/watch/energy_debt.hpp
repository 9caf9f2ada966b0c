// SPDX-License-Identifier: GPL-3.0-or-later
// Finds blocks that still owe spurious energy, which their velocities pay off (step/energy_made.cpp). They may look at
// rest in each step and yet move: low speed does not prove that they stand.
#pragma once

#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Blocks of the scene in a touching group that owes more energy than it would have at the rest speed, so that without
/// the debt it would visibly move.
std::vector<bool> in_debt(const Solid& solid);

}  // namespace blockweir::solid
