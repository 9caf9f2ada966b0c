// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// `level` of a structure that falls under the empty reservoir already.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::falls_dry_test {
namespace {

/// Beds that dip by 5 degrees with a friction of 4.9: blocks that strain creep along them, without going far for long.
TEST(FallsDry, CreepOfBlocksThatLimitAnalysisFindsToFallIsNoRest) {
  const auto scene = scene::read_text(R"(
analysis = { duration_s = 10 }
water = { upstream_level_m = 1 }
joint = { friction_angle_deg = 35 }
material.m = { youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-40, -8], [60, -8], [60, 0], [-40, 0]]
[section]
material = "m"
outline_m = [[0, 0], [11, 0], [3, 16], [0, 16]]
[[joint_set]]
name = "beds"
dip_deg = 5
spacing_m = 1.4
offset_m = 0.6
friction_angle_deg = 4.9
[[joint_set]]
name = "cross"
dip_deg = 85
spacing_m = 1.3
offset_m = 0.3
friction_angle_deg = 32
)",
                                      "falls")
                         .scene;
  const auto answer = process::level_answer(scene, hydrostatic::make);
  EXPECT_EQ(answer["limit_analysis"]["outcome"], "does not stand empty");
  EXPECT_EQ(answer["rigid_blocks"]["outcome"], "does not stand empty");
  EXPECT_EQ(answer["outcome"], "does not stand empty");
  EXPECT_TRUE(answer["difference"]["agree"].get<bool>());
  const auto sample = process::capacity_answer(scene, hydrostatic::make, process::Capacity::statics);
  EXPECT_EQ(sample["outcome"], "does not stand empty");
}

}  // namespace
}  // namespace blockweir::test::falls_dry_test
