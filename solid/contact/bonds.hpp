// SPDX-License-Identifier: GPL-3.0-or-later
// When the bond of a joint breaks.
#pragma once

#include <span>
#include <vector>

#include "solid/block/block.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/joint_laws.hpp"

namespace blockweir::solid {

/// Breaks the bonds whose strength the converged forces exceed; true if there were any: equilibrium must be found
/// again. During iterations bonds hold any force. Of a joint in tension the contacts that exceed its strength most
/// break; the next equilibrium gives the forces on the others. A bond without tension strength is lost if it is open in
/// equilibrium. In shear the brittle joint of two blocks breaks as a whole, once its shear reaches the strength of all
/// its contacts and a rigid motion of the blocks slips at all of them (solid/contact/common_slip). Before that, a
/// slipping contact passes its share to the others, wherever along the joint the bond is, and one that slips in the
/// other direction only spreads. A softening joint loses its bond with the slip. Contacts of a joint must be
/// consecutive, as the search finds them.
bool break_bonds(const JointLaws& laws, double tolerance_n, const std::vector<Block>& blocks,
                 std::span<const int> contact_ids, std::vector<ContactPoint>& contacts);

}  // namespace blockweir::solid
