// SPDX-License-Identifier: GPL-3.0-or-later
// Joints in which a scene has water: which of them are one crack, and what such a crack parts.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "bridge/scene/joint_trace.hpp"

namespace blockweir::scene {

/// The stretch of a crack between two blocks.
struct CrackPart {
  int block_a = 0;
  int block_b = 0;
  JointTrace trace;
};

/// Parts in order from the mouth.
struct Crack {
  Uplift law = Uplift::none;
  KnownHeads known;
  std::vector<CrackPart> parts;
  double length_m = 0;

  [[nodiscard]] const Point& mouth() const { return parts.front().trace.mouth(); }
  [[nodiscard]] const Point& end() const { return parts.back().trace.end(); }
};

/// Joints whose uplift is a profile between their ends. One that begins where another of the same law ends, and goes on
/// within 45 degrees of its direction, is the same crack; of several such the straightest.
std::vector<Crack> find_cracks(const Scene& scene);

/// Joints whose uplift is this law, one by one.
std::vector<Crack> find_joints(const Scene& scene, Uplift law);
/// Joints through which water flows.
std::vector<Crack> find_flow_joints(const Scene& scene);

/// In a message: the joint that the crack begins with, or its blocks.
std::string name_of(const Scene& scene, const Crack& crack);

/// Blocks that hang on no fixed or supported block once these joints (pairs of blocks, the lower index first), or those
/// of the crack, are cut; empty where they part nothing.
std::vector<int> parted_by(const Scene& scene, const std::set<std::pair<int, int>>& joints);
std::vector<int> parted_by(const Scene& scene, const Crack& crack);

}  // namespace blockweir::scene
