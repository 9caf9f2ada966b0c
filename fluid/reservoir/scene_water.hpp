// SPDX-License-Identifier: GPL-3.0-or-later
// The reservoir's water as a scene describes it.
#pragma once

#include "bridge/scene/scene.hpp"
#include "fluid/reservoir/water_matrices.hpp"

namespace blockweir::reservoir {

WaterPhysics physics_of(const scene::Scene& scene);

/// Water so shallow has no mesh: its added mass is (depth/size)^2 of that of deep water. Meshed by its depth, a long
/// film has millions of triangles.
bool is_film(const scene::Scene& scene, const hydrostatic::WaterBody& body);

/// Where the water of a body ends beyond the banks. Stated walls move with the ground.
FarEnds far_ends(const scene::Scene& scene, const hydrostatic::WaterBody& body, const Banks& banks);

/// Mesh of a body of water between banks, out to the far ends. Empty for a film, and for one without a region. Throws
/// std::runtime_error where blocks cover all of it.
WaterMesh mesh_of(const scene::Scene& scene, const hydrostatic::WaterBody& body, const Banks& banks);

}  // namespace blockweir::reservoir
