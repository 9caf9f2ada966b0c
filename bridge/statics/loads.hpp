// SPDX-License-Identifier: GPL-3.0-or-later
// The forces that a scene states, on the blocks as drawn.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/statics/wrench.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::statics {

/// Centroids of all blocks [m].
std::vector<Point> centroids_of(const scene::Scene& scene);

/// Weight of each block.
Wrenches weights_of(const scene::Scene& scene);
/// Forces of one kind, with a name.
struct NamedWrenches {
  const char* name;
  Wrenches wrenches;
};
/// The loads at `time_s` besides weight and water, by kind: stated loads, and the base acceleration as an inertia
/// force.
std::vector<NamedWrenches> stated_loads_by_name(const scene::Scene& scene, double time_s);
/// Sum of these loads.
Wrenches stated_loads_of(const scene::Scene& scene, double time_s);
/// Time until which these loads stay as they are at `time_s`; `time_s` itself if they change.
double stated_loads_hold_until(const scene::Scene& scene, double time_s);
/// Forces of the bolts' prestress.
Wrenches prestress_of(const scene::Scene& scene);
/// Forces of the pressures in a fluid's load.
Wrenches water_forces(const scene::Scene& scene, const wire::Load& load);
/// The same for the panels from `first` to before `last`.
Wrenches water_forces(const scene::Scene& scene, const wire::Load& load, std::size_t first, std::size_t last);

}  // namespace blockweir::statics
