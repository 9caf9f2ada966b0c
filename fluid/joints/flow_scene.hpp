// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a scene that the flow through joints needs, as bytes, for a program that does not read scenes.
#pragma once

#include <string>

#include "fluid/joints/joint_network.hpp"

namespace blockweir::joints {

struct FlowScene {
  scene::Scene scene;  ///< with these parts only
  GroundCut ground;
};

std::string pack(const FlowScene& scene);
/// Throws cereal::Exception if the bytes end too early.
FlowScene unpack_flow_scene(const std::string& bytes);

}  // namespace blockweir::joints
