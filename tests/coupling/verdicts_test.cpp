// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What a run says of a structure: that it stands, fails, or moves when the run ends.
#include "tests/coupling/verdicts.hpp"
#include "tests/coupling/masonry_wall.hpp"

namespace blockweir::test::verdicts_test {
namespace {

using testing::HasSubstr;

TEST_F(Verdicts, AStaticAnalysisHasTheLevelOfItsEnd) {
  Monolith dam{.analysis = "kind = \"static\"\nduration_s = 24"};
  for (const auto& [share, outcome] :
       {std::pair{0.999, "stands"}, std::pair{1.001, "fails"}, std::pair{1.2, "fails"}}) {
    dam.level =
        fmt::format("{{ table = [[0, {}], [24, {}]] }}", 0.5 * dam.sliding_level(), share * dam.sliding_level());
    const auto summary = run(dam.scene());
    EXPECT_EQ(summary["outcome"], outcome) << share << text("out");
    if (summary["outcome"] == "stands") EXPECT_GT(summary["margin"]["time_s"], 0);  // not of a start near rest
    if (summary["outcome"] != "fails") continue;
    EXPECT_NEAR(summary["failure"]["level_m"].get<double>(), share * dam.sliding_level(), 1e-9);
    EXPECT_EQ(summary["failure"]["mode"], "sliding");
  }
}

TEST_F(Verdicts, AQuasiStaticDamSlidesAtTheLevelOfADynamicOne) {
  Monolith dam{.analysis = "kind = \"quasi-static\"\nduration_s = 24\nstep_s = 0.02\nstop_at_failure = true"};
  const double level = dam.sliding_level();
  dam.level = fmt::format("{{ table = [[0, {}], [4, {}], [24, {}]] }}", 0.5 * level, 0.98 * level, 1.05 * level);
  const auto summary = run(dam.scene());
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_NEAR(summary["failure"]["level_m"].get<double>() / level, 1, 1e-4);
  EXPECT_EQ(summary["failure"]["mode"], "sliding");
}

TEST_F(Verdicts, AQuasiStaticRunEndsInFailureAndSaysWhatFollowsTheFall) {
  const nlohmann::json summary = run(R"(
analysis = { kind = "quasi-static", duration_s = 5, rigid = "all" }
joint = { friction_angle_deg = 32 }
water = { upstream_level_m = 8.42 }
material.brick = { youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 2200 }
[[block]]
name = "rock"
material = "brick"
fixed = true
vertices_m = [[-20, -3], [30, -3], [30, 0], [-20, 0]]
[[wall]]
name = "w"
material = "brick"
brick_length_m = 1
brick_height_m = 0.5
rows = 20
columns = 3
)",
                                     "--set output.frame_every_s=0.2");
  EXPECT_EQ(summary["outcome"], "fails");
  EXPECT_LT(summary["simulated_s"].get<double>(), 0.3);
  EXPECT_THAT(summary["failure"].value("end", ""), HasSubstr("kind = \"dynamic\" does"));
  EXPECT_THAT(text("out"), HasSubstr("a quasi-static analysis does not follow a fall"));
}

/// Led by 0.1 m a block pushes another along, far beyond a failure, which rests after each window.
TEST_F(Verdicts, AQuasiStaticRunGoesOnWhereWhatIsPushedRests) {
  const nlohmann::json summary = run(R"(
analysis = { kind = "quasi-static", duration_s = 1, step_s = 0.05, rigid = "all" }
material.stone = { youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
water = { upstream_level_m = 0.1 }
[[block]]
name = "ground"
material = "stone"
fixed = true
vertices_m = [[-2, -0.5], [9, -0.5], [9, 0], [-2, 0]]
[[block]]
name = "ram"
material = "stone"
vertices_m = [[0, 0], [1, 0], [1, 1], [0, 1]]
[[block]]
name = "pushed"
material = "stone"
vertices_m = [[1, 0], [2, 0], [2, 1], [1, 1]]
[[support]]
block = "ram"
point_m = [0, 0]
displacement_x_m = { from = 0, rate_per_s = 0.1 }
[[support]]
block = "ram"
point_m = [0, 1]
displacement_x_m = { from = 0, rate_per_s = 0.1 }
)");
  EXPECT_EQ(summary["simulated_s"], 1) << text("out");
}

/// By the pool's pressure below a splinter, which rests on rock as drawn, and has left it by metres after one step.
TEST_F(Verdicts, WhatUpliftThrowsUpWithinOneStepDoesNotFall) {
  for (const double size_m : {5e-5, 1e-4, 2e-4}) {
    const std::string scene = fmt::format(R"(
analysis = {{ duration_s = 0.05 }}
joint = {{ friction_angle_deg = 30, uplift = "triangular" }}
water = {{ upstream_level_m = 3 }}
{}
[[block]]
name = "splinter"
material = "masonry"
vertices_m = [[8, 0], [{}, 0], [8, {}]]
)",
                                          masonry_wall, 8 + size_m, size_m);
    const nlohmann::json failure = run(scene)["failure"];
    EXPECT_EQ(failure["mode"], "lifting") << size_m << text("out");
    EXPECT_EQ(failure["blocks"], nlohmann::json::array({"splinter"}));
    EXPECT_THAT(failure.value("doubt", ""), testing::Not(HasSubstr("nothing holds it")));
  }
}

TEST_F(Verdicts, WhatMovesAtTheEndHasNotBeenShownToStand) {
  Monolith dam{.friction_angle_deg = 33, .analysis = "duration_s = 0.4\nstep_s = 0.01"};
  dam.level =
      fmt::format("{{ table = [[0, {}], [0.1, {}]] }}", 0.999 * dam.sliding_level(), 1.003 * dam.sliding_level());
  const auto summary = run(dam.scene());
  EXPECT_EQ(summary["outcome"], "moving") << text("out");
  EXPECT_EQ(summary["moving"]["block"], "dam");
  EXPECT_GT(summary["moving"]["speed_m_per_s"].get<double>(), 1e-4);
  EXPECT_THAT(text("out"), HasSubstr("MOVING"));
  EXPECT_THAT(text("out"), HasSubstr("lengthen duration_s"));
}

TEST_F(Verdicts, WhatMovesFromTheStartFailsBelowItsFirstLevel) {
  Monolith dam;
  dam.level = fmt::format("{}", 1.05 * dam.sliding_level());
  const auto summary = run(dam.scene());
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_THAT(summary["failure"]["doubt"].get<std::string>(), HasSubstr("moves from the start"));
  EXPECT_TRUE(summary["failure"]["level_uncertainty_m"].is_null());
}

TEST_F(Verdicts, OfADamDrawnAboveItsGroundNoLevelIsSaid) {
  std::string scene = Monolith{.analysis = "duration_s = 1", .level = "10"}.scene();
  for (const auto& [drawn, above] : {std::pair{"[[0, 0], [12, 0],", "[[0, 1], [12, 1],"},
                                     std::pair{"[[joints]]\nname = \"base\"\nbetween = [\"ground\", \"dam\"]\n", ""}}) {
    scene.replace(scene.find(drawn), std::string(drawn).size(), above);
  }
  const auto summary = run(scene);
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  const auto& failure = summary["failure"];
  EXPECT_EQ(failure["mode"], "falling");
  EXPECT_TRUE(failure["level_m"].is_null());
  EXPECT_THAT(failure["doubt"].get<std::string>(), HasSubstr("nothing holds it where it is drawn"));
}

TEST_F(Verdicts, AStaticAnalysisThatFailsSaysThatItsLevelIsABound) {
  Monolith dam{.analysis = "kind = \"static\"\nduration_s = 1"};
  dam.level = fmt::format("{}", 1.1 * dam.sliding_level());
  const auto summary = run(dam.scene());
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_TRUE(summary["failure"]["level_is_bound"].get<bool>());
  EXPECT_THAT(text("out"), HasSubstr("at a level of at most "));
  EXPECT_THAT(summary["failure"]["doubt"].get<std::string>(), HasSubstr("try lower ones"));
  EXPECT_TRUE(summary["failure"]["level_uncertainty_m"].is_null());
}

TEST_F(Verdicts, WhatHasSlippedAndStandsSaysHowFar) {
  Monolith dam{.analysis = "duration_s = 2\nstep_s = 0.01"};
  const double level = dam.sliding_level();
  dam.level = fmt::format("{{ table = [[0, {}], [0.2, {}], [0.4, {}]] }}", 0.98 * level, 1.06 * level, 0.9 * level);
  const auto summary = run(dam.scene());
  ASSERT_EQ(summary["outcome"], "stands") << text("out");
  EXPECT_GT(summary["margin"]["slip_m"].get<double>(), 1e-3);
  EXPECT_EQ(summary["margin"]["slip_joint"], "base");
  EXPECT_THAT(text("out"), HasSubstr("it has slipped by"));
}

TEST_F(Verdicts, ARunTooShortToSeeAMotionDoesNotSayThatTheDamStands) {
  Monolith dam{.analysis = "duration_s = 1e-6\nstep_s = 1e-7"};
  dam.level = fmt::format("{}", 1.05 * dam.sliding_level());
  EXPECT_EQ(run(dam.scene())["outcome"], "moving") << text("out");
}

/// A block of 1 m whose weight turns back by 47 kNm what a push turns over by 120 kNm.
std::string pushed(const std::string& joint, const std::string& bolt) {
  return R"(analysis = { kind = "static", duration_s = 1 }
material.m = { youngs_modulus_pa = 2e10, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
joint = { friction_angle_deg = 60)" +
         joint + R"( }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-5, -3], [6, -3], [6, 0], [-5, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [1, 0], [1, 4], [0, 4]]
[[point_load]]
block = "wall"
point_m = [0, 4]
force_n_per_m = [30e3, 0]
)" + bolt;
}

TEST_F(Verdicts, AResultantBeyondTheBaseIsSaidToBeHeldByWhatHoldsIt) {
  const auto by_bond = run(pushed(", cohesion_pa = 600e3, tension_strength_pa = 300e3", ""));
  ASSERT_EQ(by_bond["outcome"], "stands") << text("out");
  EXPECT_LT(by_bond["margin"]["overturning"]["end_distance"], 0);
  EXPECT_EQ(by_bond["margin"]["overturning"]["held_by"], "tension strength");
  EXPECT_THAT(text("out"), HasSubstr("beyond the right end of joint \"wall on rock\""));
  EXPECT_THAT(text("out"), HasSubstr(": held by tension strength"));
  const auto by_bolt = run(pushed("",
                                  "[[bolt]]\nname = 'a'\nfrom_block = 'wall'\nfrom_m = [0.1, 4]\nto_m = [0.1, "
                                  "-2]\nstiffness_n_per_m2 = 1e9\n"));
  ASSERT_EQ(by_bolt["outcome"], "stands") << text("out");
  EXPECT_NEAR(by_bolt["margin"]["overturning"]["end_distance"], 0, 1e-6);
  EXPECT_THAT(text("out"), HasSubstr(": held by an anchor"));
}

/// 280 bricks before 4.4 m of water: what slips on the way owes energy for some steps, though nothing can move.
TEST_F(Verdicts, AWallThatOnlyStrainsStands) {
  const auto summary = run(R"(
analysis = { duration_s = 1 }
material.brick = { youngs_modulus_pa = 3e9, poissons_ratio = 0.2, density_kg_per_m3 = 1900 }
joint = { friction_angle_deg = 33 }
water = { upstream_level_m = { from = 4.0, rate_per_s = 0.4 } }
[[block]]
name = "ground"
material = "brick"
fixed = true
vertices_m = [[-8, -1], [12, -1], [12, 0], [-8, 0]]
[[wall]]
name = "w"
material = "brick"
brick_length_m = 0.4
brick_height_m = 0.25
rows = 20
columns = 14
)");
  EXPECT_EQ(summary["outcome"], "stands") << text("out");
  EXPECT_LT(summary["largest_displacement_m"], 1e-3);
}

}  // namespace
}  // namespace blockweir::test::verdicts_test
