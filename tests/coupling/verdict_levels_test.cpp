// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// The level that a run tells of a failure: of which pool it is, and what it is good for. Levels are those of limit
// equilibrium, worked out beside each scene.
#include "tests/coupling/verdicts.hpp"

namespace blockweir::test::verdict_levels_test {
namespace {

using testing::HasSubstr;

TEST_F(Verdicts, StrainUnderAFastFillingIsNoFailure) {
  Monolith high{.height_m = 300, .youngs_modulus_pa = 20e9};
  const double level = high.sliding_level();
  high.analysis = "duration_s = 40\nstep_s = 0.01\nstop_at_failure = true";
  high.level = fmt::format("{{ table = [[0, {}], [20, {}], [40, {}]] }}", 0.5 * level, 0.984 * level, 1.015 * level);
  const auto of_high = run(high.scene());
  ASSERT_EQ(of_high["outcome"], "fails") << text("out");
  const double uncertain = of_high["failure"]["level_uncertainty_m"].get<double>();
  EXPECT_NEAR(of_high["failure"]["level_m"].get<double>(), level, 1e-4 * level + uncertain);
  EXPECT_LT(uncertain, 0.01 * level);

  Monolith soft{.height_m = 10, .youngs_modulus_pa = 30e6, .friction_angle_deg = 35};
  const double soft_level = soft.sliding_level();
  soft.level = fmt::format("{{ table = [[0, {}], [4, {}], [24, {}]] }}", 0.5 * soft_level, 0.985 * soft_level,
                           1.015 * soft_level);
  const auto of_soft = run(soft.scene());
  ASSERT_EQ(of_soft["outcome"], "fails") << text("out");
  // It strains by a hundredth.
  EXPECT_NEAR(of_soft["failure"]["level_m"].get<double>() / soft_level, 1, 0.01);
}

TEST_F(Verdicts, AQuickFillingSaysThatItsLevelDependsOnTheSpeed) {
  Monolith dam{.analysis = "duration_s = 2\nstep_s = 0.01\nstop_at_failure = true"};
  const double level = dam.sliding_level();
  dam.level = fmt::format("{{ table = [[0, {}], [2, {}]] }}", 0.3 * level, 1.3 * level);
  const auto summary = run(dam.scene());
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_THAT(text("out"), HasSubstr("level"));
  ASSERT_TRUE(summary["failure"].contains("doubt")) << summary["failure"];
  EXPECT_NEAR(summary["failure"]["level_m"].get<double>(), level,
              summary["failure"]["level_uncertainty_m"].get<double>() + 1e-3 * level);
}

/// 85 blocks that slip a little on one another as the level rises seem free to move long before they do. `blockweir
/// level` finds 14.3062 m.
TEST_F(Verdicts, AJointedDamFailsWhereItsMotionBeginsNotWhereItsJointsSlipALittle) {
  const std::string dam = R"([analysis]
duration_s = 3.2
stop_at_failure = true
[material.m]
youngs_modulus_pa = 5e9
poissons_ratio = 0.2
density_kg_per_m3 = 2300
[joint]
friction_angle_deg = 35
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
friction_angle_deg = 24
[[joint_set]]
name = "cross"
dip_deg = 85
spacing_m = 1.3
offset_m = 0.3
friction_angle_deg = 32
)";
  for (const char* level : {"{ table = [[0, 13], [3, 14.6]] }", "{ from = 13, rate_per_s = 1, to = 15.5 }"}) {
    const auto summary = run(dam + "[water]\nupstream_level_m = " + level + "\n");
    ASSERT_EQ(summary["outcome"], "fails") << text("out");
    const auto& failure = summary["failure"];
    const auto uncertain = failure["level_uncertainty_m"].get<double>();
    EXPECT_NEAR(failure["level_m"].get<double>(), 14.3062, uncertain);
    EXPECT_NEAR(failure["level_m"].get<double>(), 14.3062, 0.1) << uncertain;
    EXPECT_THAT(failure["doubt"].get<std::string>(), HasSubstr("\"blockweir level SCENE\" finds the static level"));
  }
}

/// The dam of the guide's section 9. While it slides, contacts that press with 1e-11 N hold it for a step, now at one
/// level, now at another. `blockweir level` finds 10.8489 m.
TEST_F(Verdicts, TheDoubtOfASlideIsNotOfWhatHoldsItForAMomentWhileItGoesOn) {
  const std::string dam = R"([analysis]
stop_at_failure = true
[material.masonry]
youngs_modulus_pa = 10e9
poissons_ratio = 0.2
density_kg_per_m3 = 2200
[joint]
friction_angle_deg = 45
[[block]]
name = "rock"
material = "masonry"
fixed = true
vertices_m = [[-20, -6], [25, -6], [25, 0], [-20, 0]]
[section]
material = "masonry"
outline_m = [[0, 0], [9, 0], [2, 12], [0, 12]]
[[joint_set]]
name = "courses"
dip_deg = 5
spacing_m = 2
offset_m = 1
friction_angle_deg = 25
[[joint_set]]
name = "cross joints"
dip_deg = 90
spacing_m = 3
offset_m = 1.5
friction_angle_deg = 30
[water]
upstream_level_m = { from = 6, rate_per_s = 0.3 }
)";
  for (const int duration_s : {17, 18, 20}) {
    const auto summary = run(dam, fmt::format("--set analysis.duration_s={}", duration_s));
    ASSERT_EQ(summary["outcome"], "fails") << text("out");
    const auto& failure = summary["failure"];
    const auto uncertain = failure["level_uncertainty_m"].get<double>();
    EXPECT_NEAR(failure["level_m"].get<double>(), 10.8489, uncertain);
    EXPECT_NEAR(uncertain, 0.008, 5e-4) << "the guide says so";
    EXPECT_FALSE(failure.contains("doubt")) << failure;
  }
}

TEST_F(Verdicts, OfAConstantLevelNoSpeedOfFillingIsSaid) {
  Monolith dam{.height_m = 10, .youngs_modulus_pa = 30e6};
  dam.level = fmt::format("{}", 0.9 * dam.sliding_level());
  const std::string push =
      "[[point_load]]\nblock = \"dam\"\npoint_m = [0, 8]\nforce_x_n_per_m = { table = [[0, 0], [1, 4e5]] }\n";
  const auto summary = run(dam.scene() + push);
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_EQ(summary["failure"]["level_is_constant"], true);
  EXPECT_THAT(summary["failure"]["doubt"].get<std::string>(),
              testing::AllOf(HasSubstr("the level is constant"), testing::Not(HasSubstr("speed of filling"))));
}

/// Filled by 0.05 m/s the wall of 70 bricks turns over at 8.369 m; held at single levels it stands at 8.3 m, not
/// at 8.4.
TEST_F(Verdicts, TheDoubtOfAWallThatTurnsOverReachesItsStaticLevel) {
  constexpr double static_level = 8.369;
  for (const auto& [rate, from] : {std::pair{5.0, 5.0}, {1.0, 7.0}, {0.5, 7.8}}) {
    const std::string fill =
        fmt::format(" --set analysis.duration_s={} --set 'water.upstream_level_m={{from={}, rate_per_s={}, to=9.8}}'",
                    (9.8 - from) / rate, from, rate);
    fs::remove_all(folder / "w");
    ASSERT_EQ(shell(programs + "/blockweir run " + cases + "brick-dam --inproc --out w" + fill +
                    " --set analysis.stop_at_failure=true --set output.frame_every_s=100 --set expect=[]"),
              0)
        << text("out");
    const auto failure = nlohmann::json::parse(text("w/summary.json"))["failure"];
    EXPECT_NEAR(failure["level_m"].get<double>(), static_level, failure["level_uncertainty_m"].get<double>()) << rate;
  }
}

TEST_F(Verdicts, TheLevelIsThatOfTheHigherPool) {
  Monolith dam;
  const double level = dam.sliding_level();
  dam.level = fmt::format("2\ndownstream_level_m = {{ table = [[0, {}], [20, {}]] }}", 0.98 * level, 1.1 * level);
  std::string mirrored = dam.scene();
  const auto replace = [&](const std::string& from, const std::string& to) {
    const auto found = mirrored.find(from);
    ASSERT_NE(found, std::string::npos) << from;
    mirrored.replace(found, from.size(), to);
  };
  replace("[[0, 0], [12, 0], [3, 20], [0, 20]]", "[[0, 0], [12, 0], [12, 20], [9, 20]]");
  const auto summary = run(mirrored);
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_EQ(summary["failure"]["pool"], "downstream");
  // With 2 m on the other side: rho g (h^2 - 2^2)/2 = (W - rho g B (h + 2)/2) tan(phi).
  const double tangent = std::tan(33 * std::numbers::pi / 180);
  const double b = tangent * 12 / 2;
  const double constant = 4 + 2 * tangent * (2400 * 9.81 * 150 / weight_of_water - 12);
  EXPECT_NEAR(summary["failure"]["level_m"].get<double>() / (-b + std::sqrt(b * b + constant)), 1, 2e-3);
  EXPECT_EQ(summary["failure"]["head_m"], summary["failure"]["level_m"]);
  EXPECT_THAT(text("out"), HasSubstr("(downstream pool)"));
}

/// Drawdown: either level falls while the other one stands, on a block that slides to either side.
TEST_F(Verdicts, TheLevelIsThatOfThePoolThatFalls) {
  Monolith dam;
  dam.friction_angle_deg = 15;
  const double tangent = std::tan(15 * std::numbers::pi / 180);
  // With up and down: rho g |up^2 - down^2|/2 = (W - rho g B (up + down)/2) tan(phi).
  const double stays = 18;
  const double b = tangent * 12 / 2;
  const double constant = stays * stays + 2 * b * stays - 2 * tangent * 2400 * 9.81 * 12 * 20 / weight_of_water;
  const double falls = b + std::sqrt(b * b + constant);
  for (const bool downstream : {false, true}) {
    const std::string table = fmt::format("{{ table = [[0, {}], [24, {}]] }}", 1.05 * falls, 0.9 * falls);
    const std::string fixed = fmt::format("{}", stays);
    dam.level = fmt::format("{}\ndownstream_level_m = {}", downstream ? fixed : table, downstream ? table : fixed);
    std::string scene = dam.scene();
    const std::string drawn = "[[0, 0], [12, 0], [3, 20], [0, 20]]";
    scene.replace(scene.find(drawn), drawn.size(), "[[0, 0], [12, 0], [12, 20], [0, 20]]");
    const auto summary = run(scene);
    ASSERT_EQ(summary["outcome"], "fails") << text("out");
    const auto& failure = summary["failure"];
    EXPECT_EQ(failure["pool"], downstream ? "downstream" : "upstream");
    EXPECT_NEAR(failure["level_m"].get<double>() / falls, 1, 3e-3);
    EXPECT_EQ(failure["head_m"], failure["level_m"]);
    EXPECT_THAT(text("out"), HasSubstr(downstream ? "(downstream pool, falling)" : "(upstream pool, falling)"));
  }
}

TEST_F(Verdicts, ALevelThatHasNotActedIsSaid) {
  Monolith dam{.analysis = "duration_s = 24\nstep_s = 8"};
  const double level = dam.sliding_level();
  dam.level = fmt::format("{{ table = [[0, {}], [24, {}]] }}", 0.5 * level, 1.2 * level);
  const auto summary = run(dam.scene());
  EXPECT_EQ(summary["outcome"], "stands") << text("out");
  EXPECT_THAT(summary["warnings"].dump(), HasSubstr("the run ends before the last upstream level, "));
}

}  // namespace
}  // namespace blockweir::test::verdict_levels_test
