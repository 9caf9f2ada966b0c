// SPDX-License-Identifier: GPL-3.0-or-later
// Forces on everything above a surface, by kind, for a check by hand: their sum is the force on the surface.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bridge/statics/wrench.hpp"
#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

struct ForceSum {
  std::string name;     ///< "weight", a kind of loads, "bolts", "open water", "water in joints", or a part's
  Point force;          ///< N/m
  double moment_n = 0;  ///< about the surface's downstream end, counter-clockwise positive
};

/// A part of the forces of open water, on all blocks.
struct WaterPart {
  std::string name;
  statics::Wrenches wrenches;
};

/// Forces on the blocks that these joints (pairs of blocks, lower index first) separate from the ground, as drawn, at
/// the run's end; kinds that do not act are left out. Bolts have their present forces. The given parts of open water
/// are listed separately and not included in its sum.
std::vector<ForceSum> force_sums(const Solid& solid, const wire::Load& water, const std::vector<WaterPart>& parts,
                                 const std::set<std::pair<int, int>>& joints, const Point& about);

}  // namespace blockweir::solid
