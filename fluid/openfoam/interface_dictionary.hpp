// SPDX-License-Identifier: GPL-3.0-or-later
// What the plugin has to know of the scene, as OpenFOAM's constant/blockweir.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"
#include "fluid/openfoam/grid.hpp"

namespace blockweir::openfoam {

std::string interface_dictionary(const scene::Scene& scene, const Grid& grid, const std::string& endpoint);

}  // namespace blockweir::openfoam
