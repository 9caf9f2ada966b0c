// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/joint_laws.hpp"

#include <cmath>
#include <numbers>

namespace blockweir::solid {
namespace {

JointProperties properties(const scene::JointLaw& law, int joint) {
  const auto tangent = [](double degrees) { return std::tan(degrees * std::numbers::pi / 180); };
  return {.friction = tangent(law.friction_angle_deg),
          .residual_friction = tangent(law.residual_friction_angle_deg),
          .cohesion_pa = law.cohesion_pa,
          .tension_pa = law.tension_strength_pa,
          .bonded_length_m = law.bonded_length_m.value_or(-1),
          .keeps_cohesion = law.keeps_cohesion,
          .softening_slip_m = law.softening_slip_m,
          .dilation = tangent(law.dilation_angle_deg),
          .dilation_limit_m = law.dilation_limit_m.value_or(std::numeric_limits<double>::infinity()),
          .joint = joint};
}

}  // namespace

JointLaws::JointLaws(const scene::Scene& scene) {
  laws_.push_back(properties(scene.default_joint, -1));
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const auto& joint = scene.joints[j];
    by_pair_[key(joint.between[0], joint.between[1])] = static_cast<int>(laws_.size());
    laws_.push_back(properties(joint.law, static_cast<int>(j)));
  }
}

}  // namespace blockweir::solid
