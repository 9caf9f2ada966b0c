// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// The joint of a course goes to the end of its last stone, though the stone above does not press there.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::course_joints_test {
namespace {

/// The end of the middle joint was left out: 3 m of 3.9 m, with the resultant at 0.439 of it.
TEST(CourseJoints, GoToTheEndOfTheirLastStone) {
  const scene::Scene scene = scene::read_text(R"(analysis = { duration_s = 1 }
water = { upstream_level_m = 2.72 }
joint = { friction_angle_deg = 40 }
material.m = { youngs_modulus_pa = 8e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
block = [
  { name = "rock", material = "m", fixed = true, vertices_m = [[-20, -6], [35, -6], [35, 0], [-20, 0]] },
  { name = "q1-1", material = "m", vertices_m = [[0, 0], [1.5, 0], [1.5, 1], [0, 1]] },
  { name = "q1-2", material = "m", vertices_m = [[1.5, 0], [3, 0], [3, 1], [1.5, 1]] },
  { name = "q1-3", material = "m", vertices_m = [[3, 0], [4.6, 0], [3.9, 1], [3, 1]] },
  { name = "q2-1", material = "m", vertices_m = [[0, 1], [0.75, 1], [0.75, 2], [0, 2]] },
  { name = "q2-2", material = "m", vertices_m = [[0.75, 1], [2.25, 1], [2.25, 2], [0.75, 2]] },
  { name = "q2-3", material = "m", vertices_m = [[2.25, 1], [3.9, 1], [3.2, 2], [2.25, 2]] },
  { name = "q3-1", material = "m", vertices_m = [[0, 2], [1.5, 2], [1.5, 3], [0, 3]] },
  { name = "q3-2", material = "m", vertices_m = [[1.5, 2], [3.2, 2], [2.5, 3], [1.5, 3]] },
]
)",
                                              "courses.toml")
                                 .scene;
  const nlohmann::json joints = process::safety_answer(scene, hydrostatic::make)["joints"];
  ASSERT_EQ(joints.size(), 3U);
  const double drawn_m[] = {3.2, 3.9, 4.6};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(joints[k]["length_m"].get<double>(), drawn_m[k], 1e-5);
  // By hand: weights and water above it, N = 144.40 kN/m, 320.12 kN about the toe.
  EXPECT_NEAR(joints[1]["resultant_from_downstream"].get<double>(), 0.56843, 1e-4);
}

}  // namespace
}  // namespace blockweir::test::course_joints_test
