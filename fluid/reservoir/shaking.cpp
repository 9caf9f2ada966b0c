// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/shaking.hpp"

namespace blockweir::reservoir {

bool Shaking::is_steady() const {
  return scene_.water.is_shaken() && scene_.water.added_water == scene::AddedWater::reservoir;
}

Point Shaking::steady_acceleration() const {
  return -scene_.analysis.gravity_m_per_s2 *
         Point(scene_.water.earthquake_coefficient, scene_.water.earthquake_vertical_coefficient);
}

Point Shaking::stated_acceleration(const scene::TimeSpan& window) const {
  if (is_steady()) return steady_acceleration();
  if (!scene_.base_motion) return Point::Zero();
  return {scene_.base_motion->acceleration_x_m_per_s2.at(window),
          scene_.base_motion->acceleration_y_m_per_s2.at(window)};
}

bool Shaking::is_in_frame_of_ground() const {
  return is_steady() || (scene_.base_motion && scene_.base_motion->form == scene::BaseForm::inertia);
}

}  // namespace blockweir::reservoir
