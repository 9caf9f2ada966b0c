// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json fmt::fmt
// The level of failure as a user gets it: blockweir level.
#include <cmath>
#include <fstream>
#include <numbers>

#include "tests/coupling/answers.hpp"

namespace blockweir::test::level_answers_test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST_F(Answers, TheLevelOfBothExamplesIsThatOfTheFormula) {
  for (const std::string name : {"cracked-dam-upper", "cracked-dam-lower"}) {
    ASSERT_EQ(ask("level " + cases + name + " --out o --json a.json"), 0) << text("out");
    const json found = answer("a.json");
    const double head_m = found["formula"]["head_m"];
    EXPECT_NEAR(found["limit_analysis"]["head_m"].get<double>() / head_m, 1, 1e-8);
    EXPECT_NEAR(found["rigid_blocks"]["head_m"].get<double>() / head_m, 1, 1e-8);
    EXPECT_NEAR(found["head_m"].get<double>() / head_m, 1, 1e-5);
    EXPECT_LE(found["limit_analysis"]["gap"], 1e-8);
    EXPECT_EQ(found["mode"], "sliding");
    EXPECT_EQ(found["joint"], "crack");
    EXPECT_TRUE(found["difference"]["agree"].get<bool>());
    EXPECT_TRUE(fs::exists(folder / "o/mechanism.png"));
    EXPECT_EQ(answer("o/level.json"), found);
    // Heads of several joints would not compare.
    for (const char* way : {"BLOCKS ", "RIGID ", "LIMIT "}) {
      EXPECT_THAT(
          text("out"),
          ContainsRegex(
              way +
              std::string(" +fails at a level of [0-9]+[.][0-9]{4} m, [0-9]+[.][0-9]{4} m above joint \"crack\"")));
    }
  }
}

/// Whatever the section and the law of its joint: where only strain and the search are between them.
/// The upstream column of the body presses on the bed by less than a hundredth of all.
TEST_F(Answers, TheHeadOfWhatSlidesCountsFromTheVeryEndOfItsPlane) {
  ASSERT_EQ(ask("level " + cases + "jointed-dam-falls --json a.json"), 0) << text("out");
  const json found = answer("a.json");
  EXPECT_NEAR(found["head_m"].get<double>(), found["limit_analysis"]["head_m"].get<double>(), 1e-3);
  EXPECT_NEAR(found["head_m"].get<double>(), 14.907, 1e-3);
}

TEST_F(Answers, ATiltedSlopeIsToldThatLevelFillsAReservoir) {
  std::ofstream(folder / "s.toml")
      << "analysis = { duration_s = 1, gravity_tilt_deg = 10 }\njoint = { friction_angle_deg = 30 }\n"
         "material.m = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }\n"
         "[[block]]\nname = \"rock\"\nmaterial = \"m\"\nfixed = true\n"
         "vertices_m = [[-9, -3], [9, -3], [9, 0], [-9, 0]]\n"
         "[[block]]\nname = \"b\"\nmaterial = \"m\"\nvertices_m = [[0, 0], [2, 0], [2, 2], [0, 2]]\n";
  EXPECT_NE(ask("level s.toml"), 0);
  EXPECT_THAT(text("out"),
              HasSubstr("in a scene without [water]; expected gravity along the y axis: this fills a reservoir"));
}

TEST_F(Answers, LevelsOfBothWaysThatDifferByLessThanAnEngineerReadsAgree) {
  for (const double breadth_m : {3.5, 4.0, 4.5}) {
    for (const int friction_deg : {23, 25, 27}) {
      write("s.toml", block_on_rock(breadth_m, fmt::format("friction_angle_deg = {}\n", friction_deg)));
      fs::remove_all(folder / "o");
      ASSERT_EQ(ask("level s.toml --quiet --out o --json a.json"), 0) << text("out");
      const json found = answer("a.json")["difference"];
      ASSERT_TRUE(found.contains("relative")) << text("out");
      EXPECT_LE(std::abs(found["relative"].get<double>()), 1e-5);
      EXPECT_TRUE(found["agree"].get<bool>()) << text("out");
      EXPECT_THAT(text("out"),
                  ContainsRegex("\nagree   blocks less limit analysis [^\n]* m, [^\n]* of the head\n        "
                                "reason: strain, and the width of the search\n"));
    }
  }
  ASSERT_EQ(ask("level s.toml --quiet --out r --set analysis.rigid=\\\"all\\\""), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("of the head\n        reason: the width of the search\n"));
}

/// The share of the head that the two ways differ by: how deep the rock is drawn has no part in it.
TEST_F(Answers, TheDifferenceOfTwoWaysDoesNotDependOnHowDeepTheRockIsDrawn) {
  write("s.toml", block_on_rock(4, "friction_angle_deg = 25\n"));
  std::vector<double> shares;
  for (const char* below : {"-6", "-60"}) {
    fs::remove_all(folder / "o");
    ASSERT_EQ(ask(fmt::format("level s.toml --quiet --out o --json a.json --set "
                              "'block.rock.vertices_m=[[-20, {0}], [45, {0}], [45, 0], [-20, 0]]'",
                              below)),
              0)
        << text("out");
    const json found = answer("a.json");
    const json& difference = found["difference"];
    EXPECT_EQ(difference["relative_to"], "head");
    shares.push_back(difference["relative"].get<double>());
    EXPECT_NEAR(shares.back() * found["limit_analysis"]["head_m"].get<double>(), difference["level_m"].get<double>(),
                1e-12);
  }
  EXPECT_NEAR(shares[0], shares[1], 1e-6);
}

TEST_F(Answers, TwoWaysThatFindNoLevelAgree) {
  write("s.toml", block_on_rock(12, "friction_angle_deg = 60\n"));
  ASSERT_EQ(ask("level s.toml --quiet"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("\nagree   blocks and limit analysis agree\n"));
}

TEST_F(Answers, ALevelOfASceneWithoutWaterSaysWhatItAssumes) {
  const std::string asked = "level " + cases + "incline --out o";
  ASSERT_EQ(ask(asked), 0) << text("out");
  EXPECT_THAT(text("out"),
              HasSubstr("\nwater   the scene has no [water]: assumed is a reservoir of 1000 kg/m3 upstream "
                        "without tailwater, and no uplift, as no joint states one\n"));
  ASSERT_EQ(ask("level " + cases + "monolith-slides --out p"), 0) << text("out");
  EXPECT_THAT(text("out"), Not(HasSubstr("assumed is")));
}

TEST_F(Answers, AStopTellsWhatWasKnownByThen) {
  const std::string fine = " --set joint_set.bedding.spacing_m=1 --set \"joint_set.cross joint.spacing_m=1\"";
  const pid_t level = start(programs + "/blockweir level " + cases + "jointed-dam-falls --quiet --out o" + fine, "log");
  for (int wait = 0; wait < 30'000 && text("o/limit.log").find("linear systems solved") == std::string::npos; ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(level, SIGINT);
  EXPECT_EQ(end_of(level, 20), 130);
  EXPECT_THAT(text("log"), HasSubstr("blockweir: stopped on request; known by then: level by the blocks: "));
  EXPECT_THAT(text("log"), HasSubstr(" linear systems solved"));
  EXPECT_FALSE(fs::exists(folder / "o"));
}

/// As `run` does: what is wrong with the scene is said all the same.
TEST_F(Answers, QuietLeavesTheProgressOut) {
  for (const char* question : {"level ", "safety "}) {
    const std::string asked = question + cases + "monolith-slides --quiet --out o --set analysis.duration_s=1e8";
    ASSERT_EQ(ask(asked + " --set analysis.step_s=1"), 0) << text("out");
    EXPECT_THAT(text("out"), HasSubstr("duration_s in [analysis] is 1e+08 s, which is unusual"));
    EXPECT_THAT(text("out"), Not(HasSubstr("linear systems solved")));
    fs::remove_all(folder / "o");
  }
}

TEST_F(Answers, TheScenesOwnFillingHasNoPartInTheLevel) {
  ASSERT_EQ(ask("level " + cases + "monolith-slides --json a.json --set water.upstream_level_m=1"), 0) << text("out");
  ASSERT_EQ(ask("level " + cases + "monolith-slides --json b.json --set water.upstream_level_m=7 --out b"), 0);
  EXPECT_EQ(answer("a.json"), answer("b.json"));
}

TEST_F(Answers, ADamThatNoLevelFailsOrThatDoesNotStandEmptyIsAnAnswer) {
  const std::string stands = cases +
                             "monolith-slides --set joints.joint.friction_angle_deg=60 --set "
                             "joints.joint.cohesion_pa=1e6 --set joints.joint.tension_strength_pa=5e5";
  ASSERT_EQ(ask("level " + stands), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("stands at every level up to"));
  EXPECT_THAT(text("out"), HasSubstr("looked at up to the crest, "));
  EXPECT_THAT(text("out"), HasSubstr("may_overtop = true in [water] goes on to higher ones"));
  ASSERT_EQ(ask("level " + cases + "cracked-dam-upper --set joint.friction_angle_deg=10"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("LIMIT   does not stand even with an empty reservoir"));
}

/// Nothing bounds what limit analysis finds then: that is said, with the key that bounds it, and no figure is made up.
TEST_F(Answers, AnchorsThatHoldAnyForceHaveNoLimitAndTheRemedyIsTold) {
  const std::string anchor =
      "[[bolt]]\nname = 'a'\nfrom_block = 'b'\nfrom_m = [0.5, 9]\nto_m = [-3, -5]\nyoungs_modulus_pa = 2e11\n"
      "area_m2_per_m = 1e-3\n";
  const char* told = "in limit analysis anchors hold any force: state yield_n_per_m of each [[bolt]]";
  write("s.toml", block_on_rock(4, "friction_angle_deg = 30\n") + anchor);
  ASSERT_EQ(ask("level s.toml --json a.json"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("LIMIT   stands at every level up to"));
  EXPECT_THAT(text("out"), HasSubstr(told));
  ASSERT_EQ(ask("safety s.toml --json b.json"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr(told));
  const json safety = answer("b.json")["load_cases"][0];
  EXPECT_TRUE(safety["limit_analysis_factor"].is_null()) << safety["limit_analysis_factor"];
  EXPECT_TRUE(safety.contains("why_no_limit_analysis_factor"));
  write("y.toml", text("s.toml") + "yield_n_per_m = 2e5\n");
  ASSERT_EQ(ask("safety y.toml --json c.json"), 0) << text("out");
  EXPECT_TRUE(answer("c.json")["load_cases"][0]["limit_analysis_factor"].is_number());
}

TEST_F(Answers, TheEarthquakesWaterIsToldToBeWestergaards) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") + "\n[earthquake]\nhorizontal_coefficient = 0.05\n");
  ASSERT_EQ(ask("level s.toml --json a.json"), 0) << text("out");
  EXPECT_EQ(answer("a.json")["added_water_pressure"], "Westergaard");
  EXPECT_THAT(text("out"), HasSubstr("added pressure in the earthquake after Westergaard"));
  EXPECT_LT(answer("a.json")["level_m"], 7.5);
}

TEST_F(Answers, ALevelAboveTheCrestIsWarnedOf) {
  write("s.toml", block_on_rock(30, "friction_angle_deg = 50\n"));
  ASSERT_EQ(ask("level s.toml --set water.may_overtop=true"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("WARNING the water rose to"));
  ASSERT_EQ(ask("level s.toml --set water.may_overtop=true --set water.crest_pressure=full"), 0) << text("out");
  EXPECT_THAT(text("out"), Not(HasSubstr("the water rose to")));
}

/// What overturns about its toe under a head h: W b/2 + T b^2/2 = rho g h^3/6 + rho g h b^2/3.
double overturns_at_m(double breadth_m, double tension_pa) {
  const double held = 2400 * 9.81 * 10 * breadth_m * breadth_m / 2 + tension_pa * breadth_m * breadth_m / 2;
  double h = 10;
  for (int i = 0; i < 50; ++i) {
    const double off = 9810 * (h * h * h / 6 + h * breadth_m * breadth_m / 3) - held;
    h -= off / (9810 * (h * h / 2 + breadth_m * breadth_m / 3));
  }
  return h;
}

TEST_F(Answers, ATensionBeyondTheEndOfMohrCoulombsLawCountsAsThatForAllWays) {
  for (const auto& [friction_deg, cohesion_pa, tension_pa] :
       {std::tuple{50.0, 30e3, 60e3}, {50.0, 30e3, 120e3}, {50.0, 0.0, 60e3}, {40.0, 20e3, 10e3}}) {
    const double borne = std::min(tension_pa, cohesion_pa / std::tan(friction_deg * std::numbers::pi / 180));
    write("s.toml",
          block_on_rock(3, fmt::format("friction_angle_deg = {}\ncohesion_pa = {}\ntension_strength_pa = {}\n",
                                       friction_deg, cohesion_pa, tension_pa)));
    ASSERT_EQ(ask("level s.toml --json a.json"), 0) << text("out");
    const json found = answer("a.json");
    const double level_m = overturns_at_m(3, borne);
    EXPECT_NEAR(found["limit_analysis"]["level_m"].get<double>() / level_m, 1, 1e-8) << found.dump(1);
    EXPECT_NEAR(found["rigid_blocks"]["level_m"].get<double>() / level_m, 1, 1e-5) << found.dump(1);
    EXPECT_NEAR(found["level_m"].get<double>() / level_m, 1, 1e-4) << found.dump(1);
  }
}

/// Under a level that rises slowly the upright joints slip by a fraction of a millimetre at 17 m, and the dam stands
/// on. With all loads at once it falls from there on; a run that fills it by 0.1 m/s falls at 17.02 m.
TEST_F(Answers, ASlipAfterWhichTheDamRestsIsNoFailureOfASlowRise) {
  write("s.toml", R"(
title = "a dam of upright columns"
analysis = { duration_s = 1 }
material.m = { youngs_modulus_pa = 15e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
joint = { friction_angle_deg = 45 }
water = { upstream_level_m = 8 }
section = { material = "m", outline_m = [[0, 0], [9, 0], [5, 18], [1, 18]] }
joint_set = [{ name = "courses", dip_deg = 0, spacing_m = 9, offset_m = 2, friction_angle_deg = 40 },
             { name = "heads", dip_deg = 90, spacing_m = 4, offset_m = 1.2, friction_angle_deg = 32 }]
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-40, -10], [60, -10], [60, -4], [10, -4], [10, 0], [-40, 0]]
)");
  ASSERT_EQ(ask("level s.toml --json a.json"), 0) << text("out");
  const json found = answer("a.json");
  EXPECT_EQ(found["slow_rise"]["outcome"], "stands");
  EXPECT_EQ(found["limit_analysis"]["outcome"], "stands");
  EXPECT_LT(found["settles_at_m"].get<double>(), 18) << found.dump(1);
  EXPECT_THAT(text("out"), HasSubstr("blocks slip a little and then rest again"));
  ASSERT_EQ(found["outcome"], "fails") << found.dump(1);
  EXPECT_THAT(text("out"), HasSubstr("all loads at once; under a level that rises slowly it stands at every level"));
  for (const auto& [times, outcome] : {std::pair{0.999, "stands"}, {1.005, "fails"}}) {
    const double level_m = times * found["level_m"].get<double>();
    const std::string at = fmt::format("--set water.upstream_level_m={} --set analysis.kind=static", level_m);
    ASSERT_EQ(ask("run s.toml --quiet --out r" + std::string(outcome) + " " + at), 0) << text("out");
    EXPECT_EQ(answer(fmt::format("r{}/summary.json", outcome))["outcome"], outcome) << level_m;
  }
}

}  // namespace
}  // namespace blockweir::test::level_answers_test
