// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that stand on one corner: an equilibrium that the smallest push ends.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

struct CornerStand {
  int block;
  Point at_m;
};

/// Blocks that touch others at one point alone. Left out are those that something else holds: a support, a viscous
/// face, a bolt, or buoyancy.
std::vector<CornerStand> corner_stands(const Scene& scene);

}  // namespace blockweir::scene
