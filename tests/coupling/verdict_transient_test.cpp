// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt nlohmann_json::nlohmann_json
// A lowest sliding factor that is one of ringing after the start is told beside the one that is left at rest; and of a
// wall that falls into many blocks all are counted.
#include "tests/coupling/verdicts.hpp"

namespace blockweir::test::verdict_transient_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string on_jointed_rock = R"(
material.concrete = { youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
material.schist = { youngs_modulus_pa = 10e9, poissons_ratio = 0.25, density_kg_per_m3 = 2600 }
[joint]
friction_angle_deg = 40
uplift = "none"
[[block]]
name = "bedrock"
material = "schist"
fixed = true
vertices_m = [[-50, -40], [80, -40], [80, -15], [-50, -15]]
[section]
material = "concrete"
outline_m = [[-50, -15], [80, -15], [80, 0], [30, 0], [5, 30], [5, 35], [0, 35], [0, 0], [-50, 0]]
[[region]]
name = "rock mass"
material = "schist"
outline_m = [[-50, -15], [80, -15], [80, 0], [-50, 0]]
[[cut]]
name = "base"
points_m = [[-1, 0], [31, 0]]
friction_angle_deg = 45
cohesion_pa = 200e3
uplift="triangular"
[[joint_set]]
name = "foliation"
region = "rock mass"
dip_deg = -12
spacing_m = 5
friction_angle_deg = 22
[[joint_set]]
name = "cross"
region = "rock mass"
dip_deg = 78
spacing_m = 15
friction_angle_deg = 35
[water]
upstream_level_m = 20
downstream_level_m = 2
)";

TEST_F(Verdicts, ALowestFactorOfRingingIsToldBesideThatAtRest) {
  const json margin = run("analysis = { duration_s = 1.2, start = \"unstressed\" }\n" + on_jointed_rock)["margin"];
  const double at_rest = std::tan(22 * std::numbers::pi / 180) / std::tan(12 * std::numbers::pi / 180);
  EXPECT_LT(margin["sliding_factor"].get<double>(), 0.95 * at_rest);
  const std::string text = margin["text"];
  const std::string told = "; under the same level it is ";
  ASSERT_THAT(text, HasSubstr(told));
  EXPECT_NEAR(std::stod(text.substr(text.find(told) + told.size())), at_rest, 1e-3);
}

TEST_F(Verdicts, AStartThatOnlyStaticsBringsToRestDoesNotRing) {
  const json margin = run("analysis = { duration_s = 1.2 }\n" + on_jointed_rock)["margin"];
  const double at_rest = std::tan(22 * std::numbers::pi / 180) / std::tan(12 * std::numbers::pi / 180);
  EXPECT_NEAR(margin["sliding_factor"].get<double>(), at_rest, 1e-3);
}

TEST_F(Verdicts, OfAWallThatFallsAllBlocksAreCountedAndNoneIsSaidToRestThatFalls) {
  const json summary = run(R"(
analysis = { duration_s = 1.2, step_s = 0.005 }
joint = { friction_angle_deg = 35 }
material.brick = { youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 1900 }
water = { upstream_level_m = { from = 0.8, to = 1.05, rate_per_s = 1 } }
[[block]]
name = "ground"
material = "brick"
fixed = true
vertices_m = [[-6, -2], [20, -2], [20, 0], [-6, 0]]
[[wall]]
name = "w"
material = "brick"
brick_length_m = 0.3
brick_height_m = 0.12
rows = 9
columns = 1
)");
  ASSERT_EQ(summary["outcome"], "fails");
  const json& failure = summary["failure"];
  EXPECT_THAT(failure.value("doubt", ""), testing::Not(HasSubstr("came to rest again")));
  EXPECT_GT(failure["blocks"].size(), 4U);
  EXPECT_THAT(failure["text"].get<std::string>(), HasSubstr(" more"));
}

/// Free fall from the ground's edge: g t2/2 after it. Where the ground goes on the block slides on it, as far.
TEST_F(Verdicts, OfABlockThatFallsOutOfTheModelIsSaidHowFarItHasFallenAndWhatEndsTheRunSooner) {
  const auto doubt_at = [&](double duration_s, double ground_ends_m) {
    const json summary = run(fmt::format(R"(
analysis = {{ duration_s = {0}, step_s = 0.01 }}
joint = {{ friction_angle_deg = 5 }}
material.stone = {{ youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }}
water = {{ upstream_level_m = 0.9 }}
[[block]]
name = "ground"
material = "stone"
fixed = true
vertices_m = [[-2, -0.5], [{1}, -0.5], [{1}, 0], [-2, 0]]
[[block]]
name = "wall"
material = "stone"
rigid = true
vertices_m = [[0, 0], [1, 0], [1, 1], [0, 1]]
)",
                                         duration_s, ground_ends_m));
    EXPECT_EQ(summary["outcome"], "fails");
    return summary["failure"].value("doubt", "");
  };
  EXPECT_THAT(doubt_at(1, 1.1), testing::Not(HasSubstr("left the model")));
  EXPECT_THAT(doubt_at(4, 1000), testing::Not(HasSubstr("left the model")));
  EXPECT_THAT(doubt_at(4, 1.1), testing::AllOf(HasSubstr("blocks that failed have left the model"),
                                               HasSubstr("stop_at_failure = true, or a shorter duration_s")));
}

/// Thrown on to friction of 30 degrees it slides v2/(2 g tan(30)) and stops. A run that ends before says no such thing.
TEST_F(Verdicts, OfWhatSlidIntoANewEquilibriumIsSaidThatItRestsAndHowFarItCame) {
  const double speed_m_per_s = 0.5;
  const std::string scene = fmt::format(R"(
analysis = {{ duration_s = 0.5, step_s = 0.001, rigid = "all", start = "unstressed" }}
joint = {{ friction_angle_deg = 30 }}
material.stone = {{ youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }}
[[block]]
name = "ground"
material = "stone"
fixed = true
vertices_m = [[-2, -0.5], [4, -0.5], [4, 0], [-2, 0]]
[[block]]
name = "stone"
material = "stone"
vertices_m = [[0, 0], [1, 0], [1, 0.2], [0, 0.2]]
initial_velocity_m_per_s = [{}, 0]
)",
                                        speed_m_per_s);
  const double slides_m =
      speed_m_per_s * speed_m_per_s / (2 * 9.81 * std::tan(std::numbers::pi / 6));  // 2.2 cm: a failure from 1 cm
  const json summary = run(scene);
  ASSERT_EQ(summary["outcome"], "fails");
  const std::string rests = "the blocks that failed came to rest again before the run ended, at most ";
  const std::string doubt = summary["failure"].value("doubt", "");
  ASSERT_THAT(doubt, HasSubstr(rests));
  EXPECT_NEAR(std::stod(doubt.substr(doubt.find(rests) + rests.size())) / slides_m, 1, 0.02);
  EXPECT_THAT(text("out"), HasSubstr(rests));
  EXPECT_EQ(run(scene, "--set analysis.stop_at_failure=true")["failure"].count("doubt"), 0U);
}

}  // namespace
}  // namespace blockweir::test::verdict_transient_test
