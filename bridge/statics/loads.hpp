// SPDX-License-Identifier: GPL-3.0-or-later
// The forces that a scene states, on blocks where they are drawn.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/statics/wrench.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::statics {

/// Of all blocks [m].
std::vector<Point> centroids_of(const scene::Scene& scene);

/// Weight.
Wrenches weights_of(const scene::Scene& scene);
/// Forces of one kind.
struct NamedWrenches {
  const char* name;
  Wrenches wrenches;
};
/// What the scene states beside weight and water, at `time_s`, kind by kind: loads, and the base's acceleration as an
/// inertia force.
std::vector<NamedWrenches> stated_loads_by_name(const scene::Scene& scene, double time_s);
/// The sum of these.
Wrenches stated_loads_of(const scene::Scene& scene, double time_s);
/// Time until which these stay as they are at `time_s`; that itself where they change.
double stated_loads_hold_until(const scene::Scene& scene, double time_s);
/// Of bolts, by their prestress.
Wrenches prestress_of(const scene::Scene& scene);
/// Of the pressures that a fluid has said.
Wrenches water_forces(const scene::Scene& scene, const wire::Load& load);
/// Of the panels from `first` to before `last`.
Wrenches water_forces(const scene::Scene& scene, const wire::Load& load, std::size_t first, std::size_t last);

}  // namespace blockweir::statics
