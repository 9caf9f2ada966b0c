// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of joints in tension whose uplift law assumes them closed: water in a crack has the pressure of its mouth.
#pragma once

#include "solid/watch/joint_table.hpp"

namespace blockweir::solid {

/// A warning for each row in tension over more than 1 % of its length whose uplift does not follow the crack:
/// with "drained", "triangular" and "flow", and with "none" if its upstream end is below `level_m` (NaN without
/// water).
std::vector<std::string> uplift_warnings(const scene::Scene& scene, double level_m, const std::vector<JointRow>& rows);

}  // namespace blockweir::solid
