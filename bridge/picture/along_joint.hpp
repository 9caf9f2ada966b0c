// SPDX-License-Identifier: GPL-3.0-or-later
// The way along a joint, round its bends, for pictures.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace blockweir::picture {

/// A value at a place of the joint.
struct JointPoint {
  Eigen::Vector2d at_m;
  double value;
};

/// The same by the way from the joint's upstream end [m]: of its ends that of the smallest x, of equal x the highest.
struct AlongJoint {
  double way_m;
  double value;
};

/// `points`: part by part of the joint, two or more evenly spaced points of each; parts may come in any order and
/// direction. The way goes straight on across gaps between parts, such as a gallery.
std::vector<AlongJoint> along_joint(const std::vector<JointPoint>& points);

}  // namespace blockweir::picture
