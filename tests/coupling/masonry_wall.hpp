// SPDX-License-Identifier: GPL-3.0-or-later
// README's wall of masonry on rock, without its joint's law, its water and the analysis.
#pragma once

namespace blockweir::test {

inline constexpr const char* masonry_wall =
    R"(material.masonry = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
[[block]]
name = "rock"
material = "masonry"
fixed = true
vertices_m = [[-10, -3], [12, -3], [12, 0], [-10, 0]]
[[block]]
name = "wall"
material = "masonry"
vertices_m = [[0, 0], [2.5, 0], [1, 5], [0, 5]]
)";

}  // namespace blockweir::test
