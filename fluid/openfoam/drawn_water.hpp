// SPDX-License-Identifier: GPL-3.0-or-later
// The water that a scene draws for time 0, and the mesh that has to take it in.
#pragma once

#include <optional>

#include "fluid/openfoam/grid.hpp"

namespace blockweir::openfoam {

/// Of all outlines; none: the scene draws no water.
std::optional<geometry::Bounds> bounds_of_drawn_water(const scene::Scene& scene);

/// Throws scene::SceneError if keys of [fluid] let the mesh end in the drawn water: the part outside would be lost.
void require_drawn_water_inside(const scene::Scene& scene, const Grid& grid);

}  // namespace blockweir::openfoam
