// SPDX-License-Identifier: GPL-3.0-or-later
// Where the forces on joints follow from equilibrium alone, limit analysis has the factor itself; elsewhere what it has
// is an upper bound where friction is Coulomb's.
#pragma once

#include "solid/limit/connections.hpp"

namespace blockweir::solid::limit {

/// Do blocks without bonds and ties stand on each other by plane joints, as many as there are blocks that can move,
/// each of them joined to the ground? Then each joint parts the structure.
bool follow_from_equilibrium(const scene::Scene& scene, const std::vector<Face>& faces, const std::vector<Tie>& ties);

}  // namespace blockweir::solid::limit
