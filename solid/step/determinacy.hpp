// SPDX-License-Identifier: GPL-3.0-or-later
// Finds blocks whose contact forces follow from equilibrium alone, so that their stiffness does not matter.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/block/block.hpp"
#include "solid/contact/contact_point.hpp"

namespace blockweir::solid {

/// Which moving blocks are rigid; none with a mesh is. Automatic: if the group is statically determinate (as many
/// closed faces and supports as blocks: three unknown forces for each face, three equations for each block), and the
/// block's own strain under the weight of the whole group displaces its points by less than a hundredth of the failure
/// displacement.
std::vector<bool> rigid_blocks(const scene::Scene& scene, const std::vector<Block>& blocks,
                               const std::vector<ContactPoint>& contacts);

}  // namespace blockweir::solid
