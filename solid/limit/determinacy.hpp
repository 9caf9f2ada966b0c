// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether joint forces follow from equilibrium alone. Then limit analysis is exact; otherwise, with Coulomb's
// friction, it gives an upper bound.
#pragma once

#include "solid/limit/connections.hpp"

namespace blockweir::solid::limit {

/// Whether there are as many plane joints as moving blocks, without bonds and ties, and each block is connected to the
/// ground. Then each joint divides the structure in two.
bool follow_from_equilibrium(const scene::Scene& scene, const std::vector<Face>& faces, const std::vector<Tie>& ties);

}  // namespace blockweir::solid::limit
