// SPDX-License-Identifier: GPL-3.0-or-later
// A block on a plane, for scenes that say how it slides.
#pragma once

#include <string>

namespace blockweir::test {

inline const std::string block_on_plane = R"([material.rock]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500
[[block]]
name = "plane"
material = "rock"
fixed = true
vertices_m = [[-2, -1], [6, -1], [6, 0], [-2, 0]]
[[block]]
name = "block"
material = "rock"
vertices_m = [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]
)";

}  // namespace blockweir::test
