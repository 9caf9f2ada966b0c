// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of joints in tension whose uplift law assumes them closed: water in a crack has the pressure of its mouth.
#pragma once

#include "solid/watch/joint_table.hpp"

namespace blockweir::solid {

/// A warning for each row in tension over more than 1 % of its length whose uplift does not follow the crack:
/// "drained", "triangular", "flow" and "none", if the end that opens lies below the level that `water` has there.
std::vector<std::string> uplift_warnings(const scene::Scene& scene, const wire::Load& water,
                                         const std::vector<JointRow>& rows);

}  // namespace blockweir::solid
