// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// A lid sinks onto two posts under water and encloses some cells of it, which fit no motion of the lid.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_pocket_test {
namespace {

using Pocket = OpenFoam;

TEST_F(Pocket, BelowALidHasThePressureOfTheWaterAround) {
  std::ofstream(folder / "scene.toml")
      << R"(analysis = { duration_s = 4.8, step_s = 0.005, rigid = "all", start = "unstressed" }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
joint = { friction_angle_deg = 35 }
water = { upstream_level_m = 5, downstream_level_m = 5, may_overtop = true }
fluid = { model = "openfoam", cells_in_depth = 20 }
[[block]]
name = "floor"
material = "m"
fixed = true
vertices_m = [[-10, -1], [10, -1], [10, 0], [-10, 0]]
[[block]]
name = "left post"
material = "m"
fixed = true
vertices_m = [[-1.5, 0], [-0.5, 0], [-0.5, 1], [-1.5, 1]]
[[block]]
name = "right post"
material = "m"
fixed = true
vertices_m = [[0.5, 0], [1.5, 0], [1.5, 1], [0.5, 1]]
[[block]]
name = "lid"
material = "m"
vertices_m = [[-1.5, 1.6], [1.5, 1.65], [1.5, 2.25], [-1.5, 2.2]]
)";
  EXPECT_EQ(run("scene.toml", "o", ""), 0) << text("out");
  const auto summary = nlohmann::json::parse(text("o/summary.json"));
  EXPECT_EQ(summary.count("stopped"), 0U) << "its added mass was below zero in the pocket";
  EXPECT_LT(summary["added_mass"]["ratio"].get<double>(), 10);
}

}  // namespace
}  // namespace blockweir::test::openfoam_pocket_test
