// SPDX-License-Identifier: GPL-3.0-or-later
// Looks up blocks and joints of a scene by name, and computes what follows from outlines and materials.
#pragma once

#include <string>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Throw std::runtime_error if there is none of that name.
const Block& block_named(const Scene& scene, const std::string& name);
const Joint& joint_named(const Scene& scene, const std::string& name);

const Material& material_of(const Scene& scene, const Block& block);
/// N per metre of thickness.
double weight(const Scene& scene, const Block& block);
/// m, between the highest and the lowest vertex.
double height(const Block& block);

/// Bounding box of all blocks [m]; there must be one block at least.
geometry::Bounds bounds_of(const Scene& scene);

}  // namespace blockweir::scene
