// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What a run says of a structure: that it stands, fails, or moves when the run ends; how, where and at which level.
// Levels are those of limit equilibrium, worked out beside each scene. Long, as each verdict needs a scene of its own.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tests/processes.hpp"

namespace blockweir::test {
namespace {

using testing::HasSubstr;

constexpr double weight_of_water = 9810;  // N/m3

class Verdicts : public Processes {
 protected:
  /// Runs the scene in one process; its summary.
  [[nodiscard]] nlohmann::json run(const std::string& scene, const std::string& options = "") const {
    std::ofstream(folder / "scene.toml") << scene;
    EXPECT_EQ(shell(programs + "/blockweir run scene.toml --inproc --out r " + options), 0) << text("out");
    return nlohmann::json::parse(text("r/summary.json"), nullptr, false);
  }
};

/// A dam (0,0) (0.6,0) (0.15,1) (0,1) times its height on a level base, triangular uplift, density 2400.
struct Monolith {
  double height_m = 20;
  double youngs_modulus_pa = 30e9;
  double friction_angle_deg = 33;
  std::string analysis = "duration_s = 24\nstep_s = 0.01\nstop_at_failure = true";
  std::string level;

  /// Slides where H = (W - U) tan(phi): h^2/2 + tan(phi) B h/2 = W tan(phi)/(rho g).
  [[nodiscard]] double sliding_level() const {
    const double tangent = std::tan(friction_angle_deg * std::numbers::pi / 180);
    const double weight = 2400 * 9.81 * 0.375 * height_m * height_m;
    const double b = tangent * 0.6 * height_m / 2;
    return -b + std::sqrt(b * b + 2 * weight * tangent / weight_of_water);
  }
  [[nodiscard]] std::string scene() const {
    const double h = height_m;
    return fmt::format(R"([analysis]
{}
[material.c]
youngs_modulus_pa = {}
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[[block]]
name = "ground"
material = "c"
fixed = true
vertices_m = [[{}, {}], [{}, {}], [{}, 0], [{}, 0]]
[[block]]
name = "dam"
material = "c"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
[joint]
friction_angle_deg = {}
uplift = "triangular"
[[joints]]
name = "base"
between = ["ground", "dam"]
[water]
upstream_level_m = {}
may_overtop = true
[output]
frame_every_s = 100
history_every_s = 1
)",
                       analysis, youngs_modulus_pa, -2 * h, -0.3 * h, 2.6 * h, -0.3 * h, 2.6 * h, -2 * h, 0.6 * h,
                       0.15 * h, h, h, friction_angle_deg, level);
  }
};

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

/// Filled by 0.05 m/s the wall of 70 bricks turns over at 8.369 m; held at single levels it stands at 8.3 m, not
/// at 8.4.
TEST_F(Verdicts, TheDoubtOfAWallThatTurnsOverReachesItsStaticLevel) {
  constexpr double static_level = 8.369;
  for (const auto& [rate, from] : {std::pair{5.0, 5.0}, {1.0, 7.0}, {0.5, 7.8}}) {
    const std::string fill =
        fmt::format(" --set analysis.duration_s={} --set 'water.upstream_level_m={{from={}, rate_per_s={}, to=9.8}}'",
                    (9.8 - from) / rate, from, rate);
    ASSERT_EQ(shell(programs + "/blockweir run " + cases + "brick-dam --inproc --out w" + fill +
                    " --set analysis.stop_at_failure=true --set output.frame_every_s=100 --set expect=[]"),
              0)
        << text("out");
    const auto failure = nlohmann::json::parse(text("w/summary.json"))["failure"];
    EXPECT_NEAR(failure["level_m"].get<double>(), static_level, failure["level_uncertainty_m"].get<double>()) << rate;
  }
}

/// A block slides along its joint onto ground that it did not touch at the start.
TEST_F(Verdicts, BlocksThatMeetOnTheirWayAreSaidToHaveTheLawOfTheirPlane) {
  const auto box = [](const char* name, double from, double to, double low, double high, bool fixed) {
    return fmt::format(
        "[[block]]\nname = '{}'\nmaterial = 'c'\nfixed = {}\nvertices_m = [[{}, {}], [{}, {}], [{}, {}], [{}, {}]]\n",
        name, fixed, from, low, to, low, to, high, from, high);
  };
  const std::string scene =
      "[analysis]\nduration_s = 1\nstep_s = 0.01\ngravity_tilt_deg = 20\nmax_displacement_ratio = 1\n[material.c]\n"
      "youngs_modulus_pa = 3e10\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2400\n[joint]\nfriction_angle_deg = 30\n" +
      box("smooth", -4, 1.5, -1, 0, true) + box("rough", 1.5, 9, -1, 0, true) + box("sled", 0, 1, 0, 0.5, false) +
      "[[joints]]\nname = 'slide'\nbetween = ['smooth', 'sled']\nfriction_angle_deg = 5\n";
  const auto summary = run(scene);
  EXPECT_THAT(summary["warnings"].dump(),
              testing::AllOf(HasSubstr("blocks \\\"rough\\\" and \\\"sled\\\" touch now and did not at the start"),
                             HasSubstr("slid along the plane of joint \\\"slide\\\" and have its residual friction of "
                                       "5 deg; [joint] has 30 deg")));
  const auto brief = run(scene, "--set analysis.duration_s=0.3");
  EXPECT_THAT(brief["warnings"].dump(), testing::Not(HasSubstr("did not at the start")));
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

TEST_F(Verdicts, ALevelThatHasNotActedIsSaid) {
  Monolith dam{.analysis = "duration_s = 24\nstep_s = 8"};
  const double level = dam.sliding_level();
  dam.level = fmt::format("{{ table = [[0, {}], [24, {}]] }}", 0.5 * level, 1.2 * level);
  const auto summary = run(dam.scene());
  EXPECT_EQ(summary["outcome"], "stands") << text("out");
  EXPECT_THAT(summary["warnings"].dump(), HasSubstr("the run ends before the last upstream level, "));
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

/// Four lifts of 3 x 2 m, bonded to each other but not to the ground.
std::string lifts(const std::vector<int>& order, double friction_angle_deg, double from_m, double to_m) {
  std::string text = R"([analysis]
duration_s = 20
step_s = 0.01
stop_at_failure = true
[material.c]
youngs_modulus_pa = 30e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[joint]
friction_angle_deg = 60
cohesion_pa = 3e6
tension_strength_pa = 1e6
[[block]]
name = "ground"
material = "c"
fixed = true
vertices_m = [[-20, -2], [30, -2], [30, 0], [-20, 0]]
)";
  for (const int lift : order) {
    text +=
        fmt::format("[[block]]\nname = \"l{}\"\nmaterial = \"c\"\nvertices_m = [[0, {}], [3, {}], [3, {}], [0, {}]]\n",
                    lift, 2 * lift - 2, 2 * lift - 2, 2 * lift, 2 * lift);
  }
  return text + fmt::format(R"([[joints]]
name = "base"
between = ["ground", "l1"]
friction_angle_deg = {}
cohesion_pa = 0
tension_strength_pa = 0
[water]
upstream_level_m = {{ table = [[0, {}], [20, {}]] }}
may_overtop = true
)",
                            friction_angle_deg, from_m, to_m);
}

TEST_F(Verdicts, LiftsThatMoveTogetherFailOnTheJointBelowThemInAnyOrder) {
  const double weight = 3 * 8 * 2400 * 9.81;
  const double slides = std::sqrt(2 * weight * std::tan(20 * std::numbers::pi / 180) / weight_of_water);
  // Water above the crest presses on the face alone: rho g (h - 8/3 ...): H = rho g (h - 4) 8, arm 8 (3h - 8)/(6h -
  // 24)...
  const auto turning = [](double h) {  // moment of the water about the toe
    return h <= 8 ? weight_of_water * h * h * h / 6 : weight_of_water * (8 * (h - 8) * 4 + 8.0 * 8 * 8 / 6);
  };
  double turns = 8;
  while (turning(turns) < weight * 1.5) turns += 1e-4;
  for (const std::vector<int>& order : {std::vector{1, 2, 3, 4}, {4, 3, 2, 1}, {3, 1, 4, 2}}) {
    const auto slid = run(lifts(order, 20, slides - 2, slides + 1));
    ASSERT_EQ(slid["outcome"], "fails") << text("out");
    EXPECT_EQ(slid["failure"]["mode"], "sliding");
    EXPECT_EQ(slid["failure"]["joint"], "base");
    EXPECT_NEAR(slid["failure"]["head_m"].get<double>() / slides, 1, 1e-3);
    EXPECT_EQ(slid["failure"]["blocks"].size(), 4U);
    const auto turned = run(lifts(order, 55, turns - 0.5, turns + 0.5));
    ASSERT_EQ(turned["outcome"], "fails") << text("out");
    EXPECT_EQ(turned["failure"]["mode"], "overturning");
    EXPECT_EQ(turned["failure"]["joint"], "base");
    EXPECT_NEAR(turned["failure"]["head_m"].get<double>() / turns, 1, 1e-3);
  }
}

/// Two lifts on rock that beds and steep joints cut, at a level at which rock and dam go: what bears is the bedding,
/// the lift's own base on one of the pieces comes first from upstream.
TEST_F(Verdicts, ADamThatSlidesWithItsRockFailsOnTheBedding) {
  const auto slid = run(R"([analysis]
duration_s = 0.8
step_s = 0.01
[joint]
friction_angle_deg = 20
[material.concrete]
density_kg_per_m3 = 2400
youngs_modulus_pa = 25e9
poissons_ratio = 0.2
[material.rock]
density_kg_per_m3 = 2650
youngs_modulus_pa = 40e9
poissons_ratio = 0.25
[section]
material = "rock"
outline_m = [[-20, -15], [50, -15], [50, 0], [-20, 0]]
[water]
upstream_level_m = { from = 20, rate_per_s = 0.8, to = 20.5 }
[[block]]
name = "base"
material = "concrete"
vertices_m = [[0, 0], [15.5, 0], [9.4175, 11.6361], [0, 15]]
[[block]]
name = "top"
material = "concrete"
vertices_m = [[0, 15], [9.4175, 11.6361], [4, 22], [0, 22]]
[[joint_set]]
name = "bedding"
dip_deg = 12
friction_angle_deg = 8
offset_m = 1
spacing_m = 4
[[joint_set]]
name = "steep"
dip_deg = -70
offset_m = 1
persistence = 0.8
seed = 2
spacing_m = 6
trace_length_m = 8
[[joints]]
name = "crack"
between = ["base", "top"]
[[region]]
material = "rock"
fixed = true
outline_m = [[-20, -15], [50, -15], [50, -12], [-20, -12]]
)");
  ASSERT_EQ(slid["outcome"], "fails") << text("out");
  EXPECT_EQ(slid["failure"]["mode"], "sliding");
  EXPECT_EQ(slid["failure"]["joint"], "bedding");
}

}  // namespace
}  // namespace blockweir::test
