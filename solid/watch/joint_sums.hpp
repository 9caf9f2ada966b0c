// SPDX-License-Identifier: GPL-3.0-or-later
// What acts on all that stands on a surface, kind by kind, to be followed by hand: their sum is what the surface bears.
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

/// A part of what open water does, on all blocks.
struct WaterPart {
  std::string name;
  statics::Wrenches wrenches;
};

/// Of the blocks that these joints (pairs of blocks, the lower index first) part from the ground, in the scene's
/// outline, at the run's end; kinds that do not act are left out. Bolts have the forces that they have now. The parts
/// of open water have sums of their own, and no part in its own.
std::vector<ForceSum> force_sums(const Solid& solid, const wire::Load& water, const std::vector<WaterPart>& parts,
                                 const std::set<std::pair<int, int>>& joints, const Point& about);

}  // namespace blockweir::solid
