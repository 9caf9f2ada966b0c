// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Joints of a mechanism that alone do not divide the structure have their forces, for a check by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::joint_parts_test {
namespace {

using nlohmann::json;

const std::string materials = R"(joint = { friction_angle_deg = 45 }
analysis = { kind = "quasi-static", duration_s = 1, rigid = "all" }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
)";

json safety_of(const std::string& scene) {
  return process::safety_answer(scene::read_text(materials + scene, "parts.toml").scene, hydrostatic::make);
}

/// The crack upstream of the wedge opens: the seam bears all, and its strength over T is the factor.
TEST(JointParts, TheSeamBelowAWedgeWhoseCrackOpensBearsAll) {
  const json answer = safety_of(R"(earthquake = { horizontal_coefficient = 0.5 }
[[block]]
name = "upstream rock"
material = "m"
fixed = true
vertices_m = [[-20, -6], [0, -6], [0, 0], [-20, 0]]
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[0, -6], [40, -6], [40, 0], [20, 0], [0, -3]]
[[block]]
name = "wedge"
material = "m"
vertices_m = [[0, 0], [0, -3], [20, 0]]
[[joints]]
name = "crack"
between = ["wedge", "upstream rock"]
[[joints]]
name = "seam"
between = ["wedge", "rock"]
)");
  EXPECT_TRUE(answer["joints"].empty());
  ASSERT_EQ(answer["joint_parts"].size(), 2U) << answer;
  const json& seam = answer["joint_parts"][answer["joint_parts"][0]["name"] == "seam" ? 0 : 1];
  const json& crack = answer["joint_parts"][&seam == &answer["joint_parts"][0] ? 1 : 0];
  const double weight = 30 * 2400 * 9.81;
  const double dip = std::atan2(3, 20);
  const double normal = weight * (std::cos(dip) + 0.5 * std::sin(dip));
  const double shear = weight * (0.5 * std::cos(dip) - std::sin(dip));
  EXPECT_NEAR(seam["length_m"].get<double>(), std::hypot(3, 20), 1e-4);
  EXPECT_NEAR(seam["normal_n_per_m"].get<double>() / normal, 1, 1e-5);
  EXPECT_NEAR(seam["shear_n_per_m"].get<double>() / shear, 1, 1e-5);
  EXPECT_NEAR(seam["strength_n_per_m"].get<double>() / normal, 1, 1e-5);
  EXPECT_NEAR(answer["factor"].get<double>() * shear / normal, 1, 1e-3);
  EXPECT_EQ(crack["name"], "crack");
  EXPECT_NEAR(crack["normal_n_per_m"].get<double>(), 0, 1e-6 * weight);
}

/// Two walls, one behind the other: their bases are one surface, and each has its share of it. Where they fail, the
/// strength is that of the scene all the same.
TEST(JointParts, OfOneSurfaceAddUpToItsRow) {
  for (const double level_m : {3, 7}) {
    const json answer = safety_of("water = { upstream_level_m = " + std::to_string(level_m) + R"( }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-20, -6], [40, -6], [40, 0], [-20, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [2, 0], [2, 8], [0, 8]]
[[block]]
name = "buttress"
material = "m"
vertices_m = [[2, 0], [4, 0], [4, 8], [2, 8]]
[[joints]]
name = "below wall"
between = ["wall", "rock"]
friction_angle_deg = 20
uplift = "full"
[[joints]]
name = "below buttress"
between = ["buttress", "rock"]
friction_angle_deg = 20
)");
    EXPECT_EQ(answer["outcome"], level_m < 7 ? "stands" : "fails");
    ASSERT_EQ(answer["joints"].size(), 1U) << answer;
    ASSERT_EQ(answer["joint_parts"].size(), 2U) << answer;
    const json& row = answer["joints"][0];
    const auto sum = [&](const char* key) {
      return answer["joint_parts"][0][key].get<double>() + answer["joint_parts"][1][key].get<double>();
    };
    for (const char* key : {"length_m", "normal_n_per_m", "shear_n_per_m", "uplift_n_per_m"}) {
      EXPECT_NEAR(sum(key) / row[key].get<double>(), 1, 1e-4) << key;
    }
    EXPECT_NEAR(sum("strength_n_per_m") / (row["sliding_factor"].get<double>() * row["shear_n_per_m"].get<double>()), 1,
                1e-4);
  }
}

/// The apron's tip lies on the end of the seam as drawn, and lifts by a few micrometres: the seam below bears all the
/// same, along all of its length.
TEST(JointParts, ASeamWhoseThinTipLiftsHasItsForces) {
  const std::string text = R"(joint.friction_angle_deg = 24
analysis.duration_s = 1
material.m = { youngs_modulus_pa = 15e9, poissons_ratio = 0.25, density_kg_per_m3 = 2500 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-40, -14], [60, -14], [60, 0], [31, 0], [-3, -6], [-3, 0], [-40, 0]]
[[block]]
name = "slab"
material = "m"
vertices_m = [[-3, -6], [18, -2.2941176470588234], [18, 6], [-3, 6]]
[[block]]
name = "apron"
material = "m"
vertices_m = [[18, -2.2941176470588234], [31, 0], [18, 0]]
[[joints]]
name = "seam"
between = ["rock", "apron"]
uplift = "triangular"
[[joints]]
name = "steep"
between = ["slab", "apron"]
uplift = "none"
[water]
upstream_level_m = 6
downstream_level_m = 2
)";
  const json answer = process::safety_answer(scene::read_text(text, "apron.toml").scene, hydrostatic::make);
  ASSERT_EQ(answer["joint_parts"].size(), 2U) << answer;
  const json& seam = answer["joint_parts"][answer["joint_parts"][0]["name"] == "seam" ? 0 : 1];
  const double weight = 13 * 2.2941176470588234 / 2 * 2500 * 9.81;
  EXPECT_NEAR(seam["length_m"].get<double>(), std::hypot(13, 2.2941176470588234), 1e-3);
  EXPECT_GT(seam["normal_n_per_m"].get<double>(), 1e-2 * weight) << answer;
  EXPECT_GT(seam["uplift_n_per_m"].get<double>(), 1e-1 * weight);
}

}  // namespace
}  // namespace blockweir::test::joint_parts_test
