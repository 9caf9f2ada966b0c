// SPDX-License-Identifier: GPL-3.0-or-later
// What flows through each joint, and its uplift beside that of the guideline laws.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fluid/joints/flow_in_joints.hpp"

namespace blockweir::joints {

/// Of a joint: all that lies between its two blocks now. Forces are across it, by the pools' levels for the laws:
/// linear between its ends, with the drain that crosses it, and that of the higher end all along.
struct JointUplift {
  std::string name;
  double length_m = 0;
  double flow_m2_per_s = 0;  ///< the largest through a part of it
  double reynolds = 0;
  double uplift_n_per_m = 0;
  double triangular_n_per_m = 0;
  std::optional<double> drained_n_per_m{};  ///< none: no drain crosses it
  double full_n_per_m = 0;
};

/// By the order in which the joints are first met.
std::vector<JointUplift> joint_uplifts(const scene::Scene& scene, const FlowInJoints& flow);

}  // namespace blockweir::joints
