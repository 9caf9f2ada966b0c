// SPDX-License-Identifier: GPL-3.0-or-later
// Which layers of a drawing a section takes, and what on them it cannot read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/scene/read/dxf_entities.hpp"
#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// The name of the cut that a layer draws; empty for other layers.
std::string cut_of_layer(const std::string& layer);

/// The layer that draws a cut of this name, in lower case.
std::string layer_of_cut(const std::string& name);

/// Errors: what draws something on a layer that is used, and is not read. A warning for a layer that is not used, but
/// has almost the name of one; a note for other layers with lines or points.
void check_layers(const std::vector<DxfEntity>& entities, const std::filesystem::path& drawing, Problems& problems);

}  // namespace blockweir::scene
