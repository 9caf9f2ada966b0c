// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the blocks that can move as rigid bodies, and those that only strain, from the states of their contacts.
//
// A load applied quickly strains a structure and makes it oscillate, at any speed. Failure begins only if the contacts
// allow some blocks a rigid motion: a mechanism. A sticking contact blocks both relative motions of its two points, a
// slipping one the normal motion and slip in the other direction, an open one none.
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
