// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::process {

/// Throws std::invalid_argument if the scene has another fluid.
void require_fluid(const scene::Scene& scene, scene::FluidModel model);

}  // namespace blockweir::process
