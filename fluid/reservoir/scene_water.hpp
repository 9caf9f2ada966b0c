// SPDX-License-Identifier: GPL-3.0-or-later
// The reservoir's water as a scene describes it.
#pragma once

#include "bridge/scene/scene.hpp"
#include "fluid/reservoir/water_matrices.hpp"

namespace blockweir::reservoir {

WaterPhysics physics_of(const scene::Scene& scene);

/// Mesh of a body of water between blocks that are at `outlines`, out to the far ends, with nodes at `corners` of
/// faces. Empty for one without a region. Throws std::runtime_error where blocks cover all of it.
WaterMesh mesh_of(const scene::Scene& scene, const hydrostatic::WaterBody& body,
                  const std::vector<std::vector<Point>>& outlines, const std::vector<Point>& corners = {});

}  // namespace blockweir::reservoir
