// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Slopes of jointed rock that move from the start: blocks with one strain lock each other while their joints are held,
// by forces many times the weight, and these must not throw them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/scene/read/read.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid {
namespace {

scene::Scene slope(test::Random& random) {
  return scene::read_text(fmt::format(R"(
analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 65 }}
material.granite = {{ youngs_modulus_pa = 20e9, poissons_ratio = 0.25, density_kg_per_m3 = 2650 }}
[[block]]
name = "bedrock"
material = "granite"
fixed = true
vertices_m = [[-30, -10], [60, -10], [60, 60], [50, 60], [20, 0], [-30, 0]]
[section]
material = "granite"
outline_m = [[5, 0], [20, 0], [50, 60], [35, 55], [20, 30]]
[[joint_set]]
name = "foliation"
dip_deg = {:.6g}
spacing_m = {:.6g}
friction_angle_deg = {:.6g}
[[joint_set]]
name = "cross"
dip_deg = {:.6g}
spacing_m = {:.6g}
friction_angle_deg = {:.6g}
)",
                                      random.between(-45, -35), random.between(3.5, 5), random.between(45, 55),
                                      random.between(55, 65), random.between(4, 6), random.between(50, 58)),
                          "slope")
      .scene;
}

TEST(MovingSlopes, FallNoFartherThanWeightTakesThem) {
  for (int seed = 2; seed <= 2 * test::campaign(2); seed += 2) {
    test::Random random(static_cast<unsigned>(seed));
    Solid solid(slope(random));
    solid.settle({});
    const double settled_m = solid.largest_displacement_m();
    const double dt = solid.scene().analysis.step_s;
    run(solid, 2 * dt);
    EXPECT_LT(solid.largest_displacement_m() - settled_m, 9.81 * std::pow(2 * dt, 2)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace blockweir::solid
