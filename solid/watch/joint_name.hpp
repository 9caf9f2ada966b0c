// SPDX-License-Identifier: GPL-3.0-or-later
// Names of joints in reports.
#pragma once

#include <string>

#include "bridge/scene/unnamed_joint.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Its own name, or that of scene::unnamed_joint.
inline std::string joint_name(const Solid& solid, int a, int b) {
  const scene::Scene& scene = solid.scene();
  const int joint = solid.laws()[solid.laws().between(a, b)].joint;
  return joint >= 0 ? scene.joints[static_cast<std::size_t>(joint)].name : scene::unnamed_joint(scene, a, b);
}

/// The common name of a joint's pieces: that of their joint set or cut, else the joint's own name; may be empty.
inline std::string joint_set(const Solid& solid, int a, int b) {
  const int joint = solid.laws()[solid.laws().between(a, b)].joint;
  if (joint < 0) return {};
  const scene::Joint& described = solid.scene().joints[static_cast<std::size_t>(joint)];
  return described.set.empty() ? described.name : described.set;
}

}  // namespace blockweir::solid
