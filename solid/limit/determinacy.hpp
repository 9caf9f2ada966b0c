// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether joint forces follow from equilibrium alone. Then limit analysis is exact; otherwise, with Coulomb's
// friction, it gives an upper bound.
#pragma once

#include <functional>

#include "solid/limit/connections.hpp"

namespace blockweir::solid::limit {

/// Whether each joint divides the structure in two: there are as many plane joints as moving blocks, and each block is
/// connected to the ground.
bool each_joint_divides(const scene::Scene& scene, const std::vector<Face>& faces);

/// Whether two plane joints that are `weak` lie in one loop of joints: what one of them ceases to bear may then go to
/// the other.
bool share_a_loop(const scene::Scene& scene, const std::vector<Face>& faces,
                  const std::function<bool(const Face&)>& weak);

/// As each_joint_divides, without bonds and ties.
bool follow_from_equilibrium(const scene::Scene& scene, const std::vector<Face>& faces, const std::vector<Tie>& ties);

}  // namespace blockweir::solid::limit
