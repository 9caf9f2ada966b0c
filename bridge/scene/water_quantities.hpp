// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities of OpenFOAM's water for [[expect_water]], and the keys that each needs.
#pragma once

#include <array>

namespace blockweir::scene {

struct WaterQuantity {
  const char* name;
  bool of_block = false;      ///< `of`
  bool at_point = false;      ///< `at_m`
  bool regular_wave = false;  ///< needs incoming regular waves
};

inline constexpr std::array water_quantities = {
    WaterQuantity{"water_area_error"},
    WaterQuantity{"fastest_m_per_s"},
    WaterQuantity{"front_arrival_s", false, true},
    WaterQuantity{"level_arrival_s", false, true},
    WaterQuantity{"upstream_level_m"},
    WaterQuantity{"level_swing_m"},
    WaterQuantity{"level_amplitude_m", false, false, true},
    WaterQuantity{"force_x_n_per_m", true},
    WaterQuantity{"force_y_n_per_m", true},
    WaterQuantity{"force_x_amplitude_n_per_m", true, false, true},
    WaterQuantity{"added_mass_kg_per_m", true},
    WaterQuantity{"ground_added_mass_kg_per_m", true},
};

}  // namespace blockweir::scene
