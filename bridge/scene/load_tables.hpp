// SPDX-License-Identifier: GPL-3.0-or-later
// Visits all loads of a scene that may change with time.
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Calls visit(table) for each component's table of each load, and of the base acceleration.
template <class AScene, class Visit>
void each_load_table(AScene& scene, Visit visit) {
  const auto both = [&](auto& tables) {
    for (auto& table : tables) visit(table);
  };
  for (auto& load : scene.point_loads) visit(load.force_x_n_per_m), visit(load.force_y_n_per_m);
  for (auto& load : scene.face_pressures) visit(load.pressure_from_pa), visit(load.pressure_to_pa);
  for (auto& load : scene.line_loads) both(load.force_from_n_per_m2), both(load.force_to_n_per_m2);
  for (auto& load : scene.body_loads) both(load.value);
  if (scene.base_motion)
    visit(scene.base_motion->acceleration_x_m_per_s2), visit(scene.base_motion->acceleration_y_m_per_s2);
}

}  // namespace blockweir::scene
