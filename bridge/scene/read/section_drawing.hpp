// SPDX-License-Identifier: GPL-3.0-or-later
// [section] dxf = "FILE": the drawing's layers put in place of it, so that the scene's text says everything itself.
#pragma once

#include <toml++/toml.h>

#include <filesystem>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Layers: "section" (the largest closed line is the outline, others are holes), "joints" and "joints NAME" (cuts; one
/// [[cut]] NAME without points_m gives them their law), "supports" (points that are held). `folder` is where the path
/// begins. False when the scene names no drawing; what is wrong with it goes to `problems`.
bool take_drawing(toml::table& file, const std::filesystem::path& folder, Problems& problems);

}  // namespace blockweir::scene
