// SPDX-License-Identifier: GPL-3.0-or-later
// [section] dxf = "FILE": replaced by the drawing's layers, so that the scene's text is complete by itself.
#pragma once

#include <toml++/toml.h>

#include <filesystem>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Layers: "section" (the largest closed line is the outline, others are holes), "joints" and "joints NAME" (cuts; a
/// [[cut]] NAME without points_m states their law), "supports" (points that are held). The path is relative to
/// `folder`. Returns false if the scene names no drawing; errors go to `problems`.
bool take_drawing(toml::table& file, const std::filesystem::path& folder, Problems& problems);

}  // namespace blockweir::scene
