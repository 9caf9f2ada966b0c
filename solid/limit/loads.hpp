// SPDX-License-Identifier: GPL-3.0-or-later
// The forces that a scene states, on blocks where they are drawn.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"
#include "solid/limit/wrench.hpp"

namespace blockweir::solid::limit {

/// Of all blocks [m].
std::vector<Point> centroids_of(const scene::Scene& scene);

/// Weight.
Wrenches weights_of(const scene::Scene& scene);
/// What the scene states beside weight and water, at `time_s`: loads, and the base's acceleration as an inertia force.
Wrenches stated_loads_of(const scene::Scene& scene, double time_s);
/// Of the pressures that a fluid has said.
Wrenches water_forces(const scene::Scene& scene, const wire::Load& load);

}  // namespace blockweir::solid::limit
