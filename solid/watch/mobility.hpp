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

struct Mobility {
  std::vector<bool> only_strains;  ///< no rigid motion is possible: it counts as standing
  std::vector<bool> unknown;  ///< of a mechanism of many bodies (most_bodies), which is not checked: counts as possible
};

/// Of the blocks marked in `moves`, given their contacts; the others count as standing. A contact that slipped within
/// the window counts as slipping, whatever its state at the window's end.
Mobility mobility(const Solid& solid, const std::vector<bool>& moves);

}  // namespace blockweir::solid
