// SPDX-License-Identifier: GPL-3.0-or-later
// Joints in tension whose uplift takes them to be closed: water in a crack has the pressure of its mouth.
#pragma once

#include "solid/watch/joint_table.hpp"

namespace blockweir::solid {

/// A warning for each row in tension over more than 1 % of its length with uplift "drained" or "triangular".
std::vector<std::string> uplift_warnings(const scene::Scene& scene, const std::vector<JointRow>& rows);

}  // namespace blockweir::solid
