// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that bend by next to nothing.
#pragma once

#include <vector>

#include "solid/contact/formulation.hpp"

namespace blockweir::solid {

/// Contacts between the ends of such joints, each of two blocks with one strain. Held at both ends, blocks that strain
/// differently leave a gap there of the bend's size times that strain. To close it would take forces that grow as the
/// bend gets smaller, up to far more than the blocks weigh.
std::vector<int> inside_flat_joints(const Trial& trial, const std::vector<bool>& frozen, double round_off_m,
                                    const IslandContacts& island);

}  // namespace blockweir::solid
