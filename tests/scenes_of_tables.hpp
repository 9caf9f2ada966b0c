// SPDX-License-Identifier: GPL-3.0-or-later
// For each table of a scene file a sound scene that has it.
#pragma once

#include <regex>
#include <string>

namespace blockweir::test {

inline const std::string head = R"([material.m]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500
[analysis]
duration_s = 1.0
)";
inline const std::string ground = R"([[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-20, -1], [20, -1], [20, 0], [-20, 0]]
)";
inline const std::string blocks = head + R"([contact]
formulation = "penalty"
[coupling]
[output]
[joint]
cohesion_pa = 1e5
tension_strength_pa = 1e5
[[block]]
name = "a"
material = "m"
vertices_m = [[0, 0], [2, 0], [2, 2], [0, 2]]
[[block]]
name = "b"
material = "m"
vertices_m = [[0, 2], [2, 2], [2, 4], [0, 4]]
[[joints]]
name = "j"
between = ["a", "b"]
[[support]]
block = "a"
point_m = [1, 1]
displacement_x_m = 0
[[point_load]]
block = "b"
point_m = [1, 3]
force_n_per_m = [1, 0]
[[line_load]]
block = "b"
from_m = [0, 2]
to_m = [0, 4]
force_x_n_per_m2 = 1
[[face_pressure]]
block = "b"
from_m = [0, 2]
to_m = [0, 4]
pressure_pa = 1
[[body_load]]
acceleration_x_m_per_s2 = 0.1
[[bolt]]
name = "bar"
from_block = "b"
from_m = [1, 3]
to_m = [1, -0.5]
stiffness_n_per_m2 = 1e6
[base_motion]
acceleration_x_m_per_s2 = 0.1
[water]
upstream_level_m = 1
[[variant]]
name = "v"
set = ["analysis.step_s=0.002"]
[[study]]
name = "s"
kind = "critical"
key = "analysis.step_s"
from = 0.001
to = 0.002
[[limit]]
name = "l"
key = "analysis.step_s"
from = 0.001
to = 0.002
value = 0.0015
[[order]]
name = "o"
key = "analysis.step_s"
values = [0.001, 0.002, 0.004]
quantity = "kinetic_energy_j_per_m"
value = 0
order = 1
[[map]]
name = "m"
x_key = "analysis.step_s"
x_values = [0.001]
y_key = "analysis.gravity_m_per_s2"
y_values = [9]
word = "stands"
[[bench]]
name = "c"
key = "analysis.step_s"
values = [0.001]
[bench_motion]
until_s = 0.01
[[load_case]]
name = "flood"
set = ["analysis.step_s=0.01"]
[[random]]
name = "r"
key = "joint.cohesion_pa"
distribution = "normal"
mean = 1e5
deviation = 1e4
[[random]]
name = "q"
key = "joint.tension_strength_pa"
distribution = "normal"
mean = 1e5
deviation = 1e4
[[correlation]]
between = ["r", "q"]
coefficient = 0.5
[reliability]
)" + ground;

inline const std::string reservoir = R"([silt]
level_m = 0.5
submerged_density_kg_per_m3 = 900
pressure_coefficient = 0.5
[ice]
thrust_n_per_m = 1e4
thickness_m = 0.3
[earthquake]
horizontal_coefficient = 0.1
)";

/// A sound scene that has the table.
inline std::string scene_with(const std::string& table) {
  const std::string own = "[[" + table + "]]\nname = \"g\"\nmaterial = \"m\"\n";
  if (table == "arch") return head + own + "mean_radius_m = 5\nthickness_m = 1\nvoussoirs = 9\n";
  if (table == "wall") {
    return head + own + "brick_length_m = 1\nbrick_height_m = 1\nrows = 2\ncolumns = 3\n" + ground;
  }
  if (table == "viscous_boundary") {
    return head + "[[viscous_boundary]]\nblock = \"ground\"\n" +
           std::regex_replace(ground, std::regex("fixed = true\n"), "");
  }
  if (table == "heap") return head + own + "width_m = 4\nsize_m = 1\n";
  if (table == "section" || table == "region" || table == "cut" || table == "joint_set") {
    return head + ground + R"([section]
material = "m"
outline_m = [[0, 0], [8, 0], [8, 8], [0, 8]]
[[region]]
name = "foot"
material = "m"
outline_m = [[0, 0], [8, 0], [8, 2], [0, 2]]
[[cut]]
name = "c"
points_m = [[-1, 4.5], [9, 4.5]]
[[joint_set]]
name = "set"
dip_deg = 80
spacing_m = 3
spacing_deviation = 0.3
)";
  }
  if (table == "fluid.column") {
    return std::regex_replace(blocks, std::regex("upstream_level_m = 1\n"), "") +
           "[fluid]\nmodel = \"column\"\n[fluid.column]\nblock = \"a\"\nat_m = [0, 1]\nlength_m = 5\n";
  }
  if (table == "fluid.external") return blocks + "[fluid]\nmodel = \"external\"\n[fluid.external]\n";
  if (table == "fluid.reservoir") {
    return blocks + "[fluid]\nmodel = \"reservoir\"\n[fluid.reservoir]\nelement_ratio = 0.3\ncompressible = true\n";
  }
  if (table.starts_with("fluid") || table == "expect_water") {
    return blocks + "[[expect_water]]\nquantity = \"water_area_error\"\nvalue = 0\n[fluid]\nmodel = \"openfoam\"\n" +
           (table == "fluid.wave" ? "wave = { height_m = 0.1, period_s = 2 }\n" : "");
  }
  if (table == "joint_flow" || table == "drain" || table == "grout") {
    return std::regex_replace(blocks, std::regex("\\[joint\\]\n"), "[joint]\nuplift = \"flow\"\n") + R"([joint_flow]
kind = "transient"
[[drain]]
name = "d"
from_m = [1, -0.5]
to_m = [1, 0.5]
[[grout]]
name = "g"
outline_m = [[0, -0.5], [0.5, -0.5], [0.5, 0.5], [0, 0.5]]
aperture_factor = 0.5
)";
  }
  if (table == "silt" || table == "ice" || table == "earthquake") return blocks + reservoir;
  return blocks + "[[expect]]\nquantity = \"kinetic_energy_j_per_m\"\nvalue = 0\n";
}

}  // namespace blockweir::test
