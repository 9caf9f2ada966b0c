// SPDX-License-Identifier: GPL-3.0-or-later
// Which blocks can move as rigid bodies, and which only strain, by the states of their contacts.
//
// A load that comes fast strains a structure and sets it ringing, at any speed. It has begun to fail only where the
// contacts leave blocks a rigid motion of their own: a mechanism. A contact that sticks stops both relative motions of
// its two points, one that slips the normal one and a slip to the other side, an open one none.
#pragma once

#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Of the blocks marked in `moves`, those without a possible rigid motion, given their contacts; the others
/// count as standing. A contact that slipped within the window counts as slipping, whatever its state at the
/// window's end. Mechanisms of many bodies that no smaller group decides (most_bodies) count as possible without
/// a check.
std::vector<bool> only_strain(const Solid& solid, const std::vector<bool>& moves);

}  // namespace blockweir::solid
