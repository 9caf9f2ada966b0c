// SPDX-License-Identifier: GPL-3.0-or-later
// What the flow through joints needs of a scene, as bytes, for a program that does not read scenes.
#pragma once

#include <string>

#include "fluid/joints/joint_network.hpp"

namespace blockweir::joints {

struct FlowScene {
  scene::Scene scene;  ///< of which only that is filled
  GroundCut ground;
};

std::string pack(const FlowScene& scene);
/// Throws cereal::Exception where the bytes end too early.
FlowScene unpack_flow_scene(const std::string& bytes);

}  // namespace blockweir::joints
