// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Which blocks a run says to fail together, on which joint, and by which law where blocks meet on their way.
#include "tests/coupling/verdicts.hpp"

namespace blockweir::test::verdict_joints_test {
namespace {

using testing::HasSubstr;

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
  std::string parted = scene;
  parted.replace(parted.find(box("rough", 1.5, 9, -1, 0, true)), box("rough", 1.5, 9, -1, 0, true).size(),
                 box("rough", 1.5, 2, -1, 0, true) + box("far", 2, 9, -1, 0, true));
  EXPECT_THAT(run(parted)["warnings"].dump(), HasSubstr(", and 1 more pair, touch now and did not at the start"));
  const auto brief = run(scene, "--set analysis.duration_s=0.3");
  EXPECT_THAT(brief["warnings"].dump(), testing::Not(HasSubstr("did not at the start")));
}

/// Four blocks whose corners meet in a point. The upper two slide by 0.7 mm: two corners then bear.
TEST_F(Verdicts, CornersThatMeetAsDrawnAreNotSaidToTouchOnlyNow) {
  const auto block = [](const char* name, const char* more, const char* vertices) {
    return fmt::format("[[block]]\nname = '{}'\nmaterial = 'c'\n{}\nvertices_m = {}\n", name, more, vertices);
  };
  constexpr const char* thrown = "initial_velocity_m_per_s = [0.1, 0]";
  const std::string blocks =
      block("ground", "fixed = true", "[[-3, -1], [5, -1], [5, 0], [-3, 0]]") +
      block("a", "", "[[0, 0], [1, 0], [1, 1], [0, 1]]") + block("b", "", "[[1, 0], [2, 0], [2, 1], [1, 1]]") +
      block("c", thrown, "[[0, 1], [1, 1], [1, 2], [0, 2]]") + block("d", thrown, "[[1, 1], [2, 1], [2, 2], [1, 2]]");
  const auto summary =
      run("[analysis]\nduration_s = 0.5\nstep_s = 0.01\nrigid = 'all'\n[material.c]\nyoungs_modulus_pa = 3e10\n"
          "poissons_ratio = 0.2\ndensity_kg_per_m3 = 2400\n[joint]\nfriction_angle_deg = 35\n" +
          blocks + "[[joints]]\nname = 'bed'\nbetween = ['a', 'c']\nfriction_angle_deg = 30\n");
  EXPECT_THAT(summary["warnings"].dump(), testing::AllOf(HasSubstr("which only meet in a point, bear"),
                                                         testing::Not(HasSubstr("did not at the start"))));
}

/// Two supports lead the springing block of an arch away. It goes as they do: what fails is the arch above it.
TEST_F(Verdicts, ABlockThatSupportsLeadDoesNotFailWithWhatItCarried) {
  const auto block = [](const char* name, const char* more, double left, double right, double low, double high) {
    return fmt::format(
        "[[block]]\nname = '{}'\nmaterial = 'm'\n{}\nvertices_m = [[{}, {}], [{}, {}], [{}, {}], [{}, {}]]\n", name,
        more, left, low, right, low, right, high, left, high);
  };
  const auto support = [](double x) {
    return fmt::format(
        "[[support]]\nblock = 'right'\npoint_m = [{}, -0.6]\ndisplacement_y_m = 0\n"
        "displacement_x_m = {{ table = [[0, 0], [0.4, 0], [0.8, 0.6]] }}\n",
        x);
  };
  for (const char* step : {"0.0007", "0.0015", "0.003"}) {
    const auto summary =
        run(fmt::format("[analysis]\nduration_s = 1.5\nstep_s = {}\nrigid = 'all'\n", step) +
            "[material.m]\nyoungs_modulus_pa = 1e10\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2200\n[joint]\n"
            "friction_angle_deg = 38\n[[arch]]\nname = 'a'\nmaterial = 'm'\nmean_radius_m = 1.3\nthickness_m = 0.2\n"
            "voussoirs = 10\nspringings = false\n" +
            block("left", "fixed = true", -1.6, -1.2, -0.6, 0) + block("floor", "fixed = true", -5, 6, -1, -0.6) +
            block("right", "", 1.2, 1.6, -0.6, 0) + support(1.2) + support(1.6));
    EXPECT_EQ(summary["outcome"], "fails") << step;
    EXPECT_THAT(summary["failure"]["blocks"].dump(), testing::Not(HasSubstr("right"))) << step;
    EXPECT_NE(summary["failure"]["joint"], "right on floor") << step;
  }
}

/// Limit analysis of many blocks takes longer than a short run.
TEST_F(Verdicts, AFactorThatWouldTakeLongIsLeftToSafety) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases +
                  "masonry-walls --out o --set analysis.duration_s=0.05 "
                  "--set expect=[] --set 'analysis.rigid=\"all\"'"),
            0);
  EXPECT_THAT(text("out"), HasSubstr("none: a run looks for it only up to 300 faces between blocks, and here are 326; "
                                     "\"blockweir safety\" finds it, which may take long"));
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

/// A slab goes up the slope while the block on it goes down, over ground that begins to move, too. By a random scene.
const char* const passing = R"(title = "t"
[analysis]
duration_s = 0.5
rigid = "all"
gravity_tilt_deg = -0.3368568499751241
[joint]
friction_angle_deg = 8.780132021722837
[material.m]
youngs_modulus_pa = 10e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500.0
[material.r0]
youngs_modulus_pa = 10e9
poissons_ratio = 0.2
density_kg_per_m3 = 221.7512504006568
[material.r1]
youngs_modulus_pa = 10e9
poissons_ratio = 0.2
density_kg_per_m3 = 1000.8502418283606
[material.r2]
youngs_modulus_pa = 10e9
poissons_ratio = 0.2
density_kg_per_m3 = 1514.7617614068417
[[block]]
name = "ground"
material = "m"
vertices_m = [[-2586.6164576358524, 1177.454573649717], [-2630.3212315591168, 1094.8082073264227], [2328.4607478385574, -1527.4782280694449], [2372.1655217618218, -1444.8318617461505]]
fixed = true
[[block]]
name = "b2"
material = "r2"
vertices_m = [[-173.0708537089016, -86.84298641083379], [-174.38639347262563, -89.33069133333245], [-32.75648109973294, -164.22694601941845], [-31.44094133600892, -161.73924109691978]]
[[block]]
name = "b1"
material = "r1"
vertices_m = [[-185.18553206299546, -83.6199271260852], [-186.4687593676179, -86.04652871611026], [-23.240569813985545, -172.36431181669073], [-21.957342509363116, -169.9377102266657]]
initial_velocity_m_per_s = [-3.4095526829506246, 1.8030282009605556]
[[block]]
name = "b0"
material = "r0"
vertices_m = [[-326.322587142428, -12.08949712331966], [-328.6933904886418, -16.572720905135753], [114.24245461461084, -250.80456719129742], [116.6132579608246, -246.32134340948133]]
[[joints]]
name = "j0"
between = ["ground", "b0"]
friction_angle_deg = 6.820168596713658
[[joints]]
name = "j1"
between = ["b0", "b1"]
friction_angle_deg = 36.61952626115617
[[joints]]
name = "j2"
between = ["b1", "b2"]
friction_angle_deg = 6.014241387208565
)";

TEST_F(Verdicts, ABlockOnOneThatGoesTheOtherWaySlidesOnIt) {
  const auto summary = run(passing);
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_EQ(summary["failure"]["mode"], "sliding");
  EXPECT_EQ(summary["failure"]["joint"], "j2");
  EXPECT_EQ(summary["failure"]["blocks"], nlohmann::json({"b2"}));
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("nothing holds it")));
}

}  // namespace
}  // namespace blockweir::test::verdict_joints_test
