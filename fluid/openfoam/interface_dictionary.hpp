// SPDX-License-Identifier: GPL-3.0-or-later
// What the plugin has to know of the scene, as OpenFOAM's constant/blockweir.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"
#include "fluid/openfoam/grid.hpp"

namespace blockweir::openfoam {

/// `first_window`: the motion that a run is resumed with; 0 from the start.
std::string interface_dictionary(const scene::Scene& scene, const Grid& grid, const std::string& endpoint,
                                 std::uint64_t first_window);

}  // namespace blockweir::openfoam
