// SPDX-License-Identifier: GPL-3.0-or-later
// When the bond of a joint breaks.
#pragma once

#include <span>
#include <vector>

#include "solid/block/block.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/joint_laws.hpp"

namespace blockweir::solid {

/// Breaks the bonds that the converged forces exceed; true if there were any: equilibrium is to be found again. Bonds
/// hold until then, whatever iterates asked of them. Of a joint in tension the contacts break that exceed its strength
/// most; what the others bear without them is told by the next equilibrium. One without tension strength is let go: its
/// bond is lost if it is open in equilibrium. In shear the brittle joint of two blocks breaks as a whole, once its
/// shear reaches the strength of all its contacts and a rigid motion of the blocks slips at all of them
/// (solid/contact/common_slip): before, one that slips hands its share to the others, wherever along the joint the bond
/// is, and one that slips to the other side only spreads. A softening one loses its bond with the slip. Contacts of a
/// joint follow each other, as the search finds them.
bool break_bonds(const JointLaws& laws, double tolerance_n, const std::vector<Block>& blocks,
                 std::span<const int> contact_ids, std::vector<ContactPoint>& contacts);

}  // namespace blockweir::solid
