// SPDX-License-Identifier: GPL-3.0-or-later
// The joints of a scene: all pairs of touching blocks, stated or not.
#pragma once

#include <map>
#include <set>
#include <utility>

#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Pairs of blocks (lower index first) that share a part of their outlines and are not both fixed. Blocks closer than
/// `touching_m` touch.
std::set<std::pair<int, int>> touching_pairs(const Scene& scene, double touching_m);

/// The same, with the line that they share.
std::map<std::pair<int, int>, JointTrace> touching_joints(const Scene& scene, double touching_m);

}  // namespace blockweir::scene
