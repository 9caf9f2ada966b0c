// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure of still water, equation (9).
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// rho g [N/m3]
inline double unit_weight_of_water(const Scene& scene) {
  return scene.water.density_kg_per_m3 * scene.analysis.gravity_m_per_s2;
}

/// P = P0 + rho g z, where z is the depth below the level; zero above the level.
struct Hydrostatics {
  double weight_n_per_m3 = 9810;  ///< rho g
  double atmosphere_pa = 0;       ///< P0, on wet faces alone
  double level_m = 0;

  [[nodiscard]] double pressure(double y) const {
    return y <= level_m ? atmosphere_pa + weight_n_per_m3 * (level_m - y) : 0;
  }
};

/// For wet faces of a pool with this level.
inline Hydrostatics on_wet_faces(const Scene& scene, double level_m) {
  const Water& w = scene.water;
  return {.weight_n_per_m3 = unit_weight_of_water(scene),
          .atmosphere_pa = w.atmosphere == Atmosphere::wet_faces ? w.atmospheric_pressure_pa : 0,
          .level_m = level_m};
}
/// For joints: the atmosphere acts on both sides and cancels.
inline Hydrostatics in_joints(const Scene& scene, double level_m) {
  return {.weight_n_per_m3 = unit_weight_of_water(scene), .level_m = level_m};
}

}  // namespace blockweir::scene
