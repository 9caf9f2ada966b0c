// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks whose velocities pay for energy that a step has made of nothing (step/energy_made.cpp). They may be at rest in
// each step and yet go on: that they are slow does not tell that they stand.
#pragma once

#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Of the scene's blocks, those in a group in contact that owes more than it would have at the speed of rest: with that
/// it would be seen to move.
std::vector<bool> in_debt(const Solid& solid);

}  // namespace blockweir::solid
