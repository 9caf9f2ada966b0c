// SPDX-License-Identifier: GPL-3.0-or-later
// Can two blocks slip at all contacts of their joint at once?
#pragma once

#include <span>
#include <vector>

#include "solid/block/block.hpp"
#include "solid/contact/contact_point.hpp"

namespace blockweir::solid {

/// Is there a rigid motion of the one block against the other, as the scene's outline has them, that slips at each
/// contact that slips and presses or opens none that is closed? Where faces meet at an angle there may be none: what
/// slips there strains, until a contact opens.
bool slips_as_one(const std::vector<Block>& blocks, const std::vector<ContactPoint>& contacts,
                  std::span<const int> joint);

}  // namespace blockweir::solid
