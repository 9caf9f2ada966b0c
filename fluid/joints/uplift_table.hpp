// SPDX-License-Identifier: GPL-3.0-or-later
// The flow through each joint, and its uplift compared with guideline laws.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fluid/joints/flow_in_joints.hpp"

namespace blockweir::joints {

/// All parts of a joint between two blocks. Forces are normal to the joint. The laws use the pools' levels: linear
/// between the ends; with the drain that crosses it; and the higher end's pressure everywhere.
struct JointUplift {
  std::string name;
  double length_m = 0;
  double flow_m2_per_s = 0;  ///< largest in any part
  double reynolds = 0;
  double uplift_n_per_m = 0;
  double triangular_n_per_m = 0;
  std::optional<double> drained_n_per_m{};  ///< none: no drain crosses it
  double full_n_per_m = 0;
};

/// In the order in which the joints are first found.
std::vector<JointUplift> joint_uplifts(const scene::Scene& scene, const FlowInJoints& flow);

}  // namespace blockweir::joints
