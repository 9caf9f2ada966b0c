// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic fluid_reservoir bridge_scene_read bridge_schedule
// Walls that bend and strain before a reservoir: a run swings with the frequency of structure and water as they are
// solved for together, whatever damps it or not, and loses or gains nothing.
#include <gtest/gtest.h>

#include "tests/verification/swinging_wall.hpp"

namespace blockweir::solid::bending_in_reservoir_test {
namespace {

class BendingInReservoir : public testing::TestWithParam<Wall> {};

TEST_P(BendingInReservoir, SwingsAsStructureAndWaterTogetherAndGainsNoEnergy) {
  const double exact = wet_frequency(GetParam());
  const Swing swing = swing_of(GetParam(), exact);
  EXPECT_NEAR(swing.omega / exact, 1, 5e-4);
  EXPECT_LT(swing.growth, 1.05);
  EXPECT_GT(swing.growth, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Walls, BendingInReservoir,
                         testing::Values(Wall{}, Wall{.schedule = "parallel"}, Wall{.schedule = "improved"},
                                         Wall{.integrator = "shi", .step_s = 0.001}, Wall{.density_kg_per_m3 = 300},
                                         Wall{.mesh_size_m = 0, .step_s = 0.0005}));

/// A light wall with sloping faces on ice, pressed down by a load of 13.7 MN/m that acts at once, and pushed.
scene::Scene wall_on_ice(double youngs_modulus_pa, const char* schedule) {
  return scene::read_text(fmt::format(R"(coupling = {{ schedule = "{}", window_s = 0.002 }}
joint = {{ friction_angle_deg = 0 }}
water = {{ upstream_level_m = 7.3 }}
fluid = {{ model = "reservoir", reservoir = {{ upstream_wall_m = -12 }} }}
material.m = {{ youngs_modulus_pa = {}, poissons_ratio = 0.2, density_kg_per_m3 = 50 }}
point_load = [ {{ block = "wall", point_m = [3.8, 0], force_n_per_m = [0, -1.37e7] }} ]
body_load = [ {{ blocks = ["wall"], force_x_n_per_m3 = 300 }} ]
[analysis]
duration_s = 0.1
step_s = 0.002
gravity_m_per_s2 = 0
start = "unstressed"
integrator = "trapezoidal"
max_displacement_ratio = 1
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-12, -3], [22, -3], [22, 0], [-12, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [7.6, 0], [6.2, 7.5], [1.6, 7.5]]
)",
                                      schedule, youngs_modulus_pa),
                          "ice")
      .scene;
}

/// Its damping, which begins as it slides, takes nothing of that.
TEST(StrainInReservoir, AWallThatBeginsToSlideHasTheMomentumOfItsLoad) {
  for (const char* schedule : {"serial", "parallel", "improved"}) {
    for (const double youngs_modulus_pa : {1e9, 1e10, 1e11}) {
      const scene::Scene scene = wall_on_ice(youngs_modulus_pa, schedule);
      Blocks blocks(scene);
      run_with_reservoir(scene, blocks);
      const Block& wall = blocks.solid.blocks()[1];
      const double exact = 300 * wall.area * 0.1 / (wall.mass_per_m() + blocks.masses.own[1](0, 0));
      EXPECT_NEAR(blocks.solid.states()[1].velocity[0] / exact, 1, 2e-3) << schedule << youngs_modulus_pa;
    }
  }
}

}  // namespace
}  // namespace blockweir::solid::bending_in_reservoir_test
