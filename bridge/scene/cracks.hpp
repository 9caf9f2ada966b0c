// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the joints that contain water, groups them into cracks, and finds which blocks a crack separates.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "bridge/scene/joint_trace.hpp"

namespace blockweir::scene {

/// The part of a crack between two blocks.
struct CrackPart {
  int block_a = 0;
  int block_b = 0;
  JointTrace trace;
};

/// Parts in order, starting at the mouth.
struct Crack {
  Uplift law = Uplift::none;
  KnownHeads known;
  std::vector<CrackPart> parts;
  double length_m = 0;
  std::vector<Bend> bends{};  ///< by station; none along a straight crack

  [[nodiscard]] const Point& mouth() const { return parts.front().trace.mouth(); }
  [[nodiscard]] const Point& end() const { return parts.back().trace.end(); }
};

/// Cracks of joints whose uplift is a profile between their ends. A joint that starts where another with the same law
/// ends, and deviates from its direction by less than 45 degrees, extends that crack; of several, the straightest.
std::vector<Crack> find_cracks(const Scene& scene);

/// Joints with this uplift law, one crack each.
std::vector<Crack> find_joints(const Scene& scene, Uplift law);
/// Joints with seepage flow (uplift = "flow").
std::vector<Crack> find_flow_joints(const Scene& scene);

/// For messages: the name of the crack's first joint, or of its blocks.
std::string name_of(const Scene& scene, const Crack& crack);

/// Blocks that lose every connection to a fixed or supported block when these joints (pairs of blocks, lower index
/// first), or those of the crack, are cut. Empty if none does.
std::vector<int> parted_by(const Scene& scene, const std::set<std::pair<int, int>>& joints);
std::vector<int> parted_by(const Scene& scene, const Crack& crack);

}  // namespace blockweir::scene
