// SPDX-License-Identifier: GPL-3.0-or-later
// Where stiffness cannot matter: blocks whose contact forces follow from equilibrium alone.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/block/block.hpp"
#include "solid/contact/contact_point.hpp"

namespace blockweir::solid {

/// Which movable blocks are rigid; none with a mesh is. Automatic: where every face that is closed at the start carries
/// one block (as many faces and supports as blocks in the group, three unknown forces a face, three equations a block),
/// and the block's own strain under the weight of the whole group moves its points by less than a hundredth of the
/// displacement that counts as failure.
std::vector<bool> rigid_blocks(const scene::Scene& scene, const std::vector<Block>& blocks,
                               const std::vector<ContactPoint>& contacts);

}  // namespace blockweir::solid
