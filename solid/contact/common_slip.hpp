// SPDX-License-Identifier: GPL-3.0-or-later
// Can two blocks slip at all contacts of their joint at once?
#pragma once

#include <span>
#include <vector>

#include "solid/block/block.hpp"
#include "solid/contact/contact_point.hpp"

namespace blockweir::solid {

/// Whether a rigid motion of one block relative to the other, as drawn, slips at each slipping contact without pressing
/// or opening a closed one. If faces meet at an angle there may be none: the slip then strains the blocks, until a
/// contact opens.
bool slips_as_one(const std::vector<Block>& blocks, const std::vector<ContactPoint>& contacts,
                  std::span<const int> joint);

}  // namespace blockweir::solid
