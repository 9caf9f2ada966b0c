// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json fmt::fmt
// Answers without a run, as a user gets them: blockweir level, blockweir safety.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "tests/coupling/answers.hpp"

namespace blockweir::test {
namespace {

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
    EXPECT_THAT(found["difference"]["reason"].get<std::string>(), HasSubstr("deformation"));
    EXPECT_TRUE(fs::exists(folder / "o/mechanism.png"));
    EXPECT_EQ(answer("o/level.json"), found);
  }
}

TEST_F(Answers, TheLevelsOfBothWaysAreSaidToAgree) {
  ASSERT_EQ(ask("level " + cases + "monolith-slides --out o --json a.json --set analysis.rigid=\\\"all\\\""), 0)
      << text("out");
  EXPECT_TRUE(answer("a.json")["difference"]["agree"].get<bool>());
  EXPECT_THAT(text("out"), HasSubstr("\nagree   blocks and limit analysis agree\n"));
}

TEST_F(Answers, ThePressuresOfTheWaterKindByKindHaveTheSumsOfTheJoint) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") +
                      "[ice]\nthrust_n_per_m = 20e3\nthickness_m = 0.4\n[earthquake]\nhorizontal_coefficient = 0.05\n");
  ASSERT_EQ(ask("safety s.toml --json a.json --set water.upstream_level_m=5"), 0) << text("out");
  const json found = answer("a.json")["load_cases"][0];
  std::map<std::string, double> sums;
  for (const json& sum : found["joints"][0]["sums"]) sums[sum["name"]] = sum["x_n_per_m"];
  for (const char* name : {"open water", "ice", "added water (Westergaard)"}) {
    double force = 0;
    for (const json& kind : found["water"]) {
      if (kind["name"] != name) continue;
      for (const json& p : kind["panels"]) {
        const double inward_x_m = p[1].get<double>() - p[3].get<double>();
        if (p[6] != 0) force += (p[4].get<double>() + p[5].get<double>()) / 2 * inward_x_m;
      }
    }
    EXPECT_NEAR(force / sums.at(name), 1, 1e-5) << name << ": the sums are of blocks that have strained";
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
  ASSERT_EQ(ask("level " + cases + "cracked-dam-upper --set joint.friction_angle_deg=10"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("LIMIT   does not stand even with an empty reservoir"));
}

TEST_F(Answers, TellAFactorBelowOneOfWhatFails) {
  ASSERT_EQ(ask("safety " + cases + "monolith-slides --json a.json --set water.upstream_level_m=7.9"), 0)
      << text("out");
  const json found = answer("a.json")["load_cases"][0];
  EXPECT_EQ(found["outcome"], "fails");
  EXPECT_LT(found["factor"], 1);
  EXPECT_GT(found["factor"], 0.9);
  EXPECT_NEAR(found["factor"].get<double>() / found["limit_analysis_factor"].get<double>(), 1, 1e-5);
}

TEST_F(Answers, IceAndTheEarthquakesWaterHaveSumsOfTheirOwnAndTheLoadsThatGrowAreNamed) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") +
                      "\n[ice]\nthrust_n_per_m = 20e3\nthickness_m = 0.5\n[earthquake]\nhorizontal_coefficient = 0.02\n"
                      "[silt]\nlevel_m = 1\nsubmerged_density_kg_per_m3 = 900\npressure_coefficient = 0.5\n");
  ASSERT_EQ(ask("safety s.toml --json a.json --set water.upstream_level_m=4 --set water.downstream_level_m=1 --set "
                "expect=[] --set variant=[] --set face_pressure=[]"),
            0)
      << text("out");
  const json found = answer("a.json")["load_cases"][0];
  std::map<std::string, json> sums;
  for (const json& sum : found["joints"][0]["sums"]) sums[sum["name"]] = sum;
  constexpr double water = 9810.0 * (16 - 1) / 2;
  EXPECT_NEAR(sums["open water"]["x_n_per_m"].get<double>() / water, 1, 1e-5);  // on blocks that have settled
  EXPECT_NEAR(sums["ice"]["x_n_per_m"].get<double>() / 20e3, 1, 1e-6);
  const double westergaard = 7.0 / 12 * 0.02 * 9810 * 16;  // on an upright face
  EXPECT_NEAR(sums["added water (Westergaard)"]["x_n_per_m"].get<double>() / westergaard, 1, 1e-6);
  EXPECT_EQ(found["tailwater_m"], 1);
  EXPECT_THAT(text("out"),
              HasSubstr("times [silt] and [earthquake], by limit analysis; as stated: weight and water and ice and"));
  EXPECT_THAT(text("out"), HasSubstr("as it stands: tailwater at 1 m"));
  EXPECT_THAT(text("out"), HasSubstr("moments about (3.5, 0) m"));
}

/// A wall on a joint that dips to level rock at its toe: 1.2611 at 4.9 m by a linear program written for it alone.
TEST_F(Answers, AToeInAReflexCornerOfTheRockIsHeldByBothEdges) {
  write("s.toml", R"(
analysis = { duration_s = 3, rigid = "all" }
water.upstream_level_m = 4.9
joint.friction_angle_deg = 30
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-10, -4], [14, -4], [14, -0.5], [3, -0.5], [0, 0], [-10, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [3, -0.5], [2, 5], [0, 5]]
)");
  ASSERT_EQ(ask("safety s.toml --json a.json"), 0) << text("out");
  const json found = answer("a.json")["load_cases"][0];
  EXPECT_NEAR(found["factor"], 1.2611, 1e-4);
  EXPECT_NEAR(found["limit_analysis_factor"], 1.2611, 1e-4);
}

/// A soft anchor that pulls down and downstream: 1.191 by hand; going slack it would be 1.897.
TEST_F(Answers, AnAnchorKeepsItsPrestressAndWhatHoldsAnyForceIsTold) {
  const std::string scene = R"(
analysis = { duration_s = 0.5, rigid = "all" }
water.upstream_level_m = 3.5
joint.friction_angle_deg = 30
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-10, -5], [12, -5], [12, 0], [-10, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [2.5, 0], [1, 5], [0, 5]]
[[bolt]]
name = "a"
from_block = "wall"
from_m = [0.3, 4.5]
to_m = [7, -4]
stiffness_n_per_m2 = 1e3
prestress_n_per_m = 150e3
)";
  write("s.toml", scene + "yield_n_per_m = 150e3\n");
  ASSERT_EQ(ask("run s.toml --quiet --out r"), 0) << text("out");
  // (197426 + 150000 8.5/10.8231) tan(30) / (60086 + 150000 6.7/10.8231): weight, water, prestress
  EXPECT_NEAR(answer("r/summary.json")["limit_analysis"]["factor"], 1.18999, 1e-4);
  EXPECT_THAT(text("out"), HasSubstr("\nFACTOR  at most 1.19"));
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("anchors hold any force")));
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("anchors at their yield force")));
  write("s.toml", scene + "yield_n_per_m = 200e3\n");
  ASSERT_EQ(ask("run s.toml --quiet --out r"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("limit analysis takes anchors at their yield force"));
  ASSERT_EQ(ask("safety s.toml --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("limit: limit analysis takes anchors at their yield force"));
  ASSERT_EQ(ask("level s.toml --out l --set joint.friction_angle_deg=16 --set bolt.a.to_m=[-7,-4] --set "
                "bolt.a.prestress_n_per_m=50e3"),
            0)
      << text("out");
  EXPECT_THAT(text("out"), HasSubstr("reason: limit analysis takes anchors at their yield force"));
  write("s.toml", scene);
  ASSERT_EQ(ask("run s.toml --quiet --out r"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("anchors hold any force: state yield_n_per_m"));
  ASSERT_EQ(ask("safety s.toml --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("limit: in limit analysis anchors hold any force"));
  const std::string failing =
      " --set joint.friction_angle_deg=5 --set bolt.a.prestress_n_per_m=0 --set bolt.a.to_m=[-7,-4]";
  ASSERT_EQ(ask("run s.toml --quiet --out f" + failing), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("FAILS"));
  EXPECT_THAT(text("out"), HasSubstr("in limit analysis anchors hold any force: state yield_n_per_m"));
  ASSERT_EQ(ask("level s.toml --out l" + failing), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("reason: in limit analysis anchors hold any force"));
}

TEST_F(Answers, TheEarthquakesWaterIsToldToBeWestergaards) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") + "\n[earthquake]\nhorizontal_coefficient = 0.05\n");
  ASSERT_EQ(ask("level s.toml --json a.json"), 0) << text("out");
  EXPECT_EQ(answer("a.json")["added_water_pressure"], "Westergaard");
  EXPECT_THAT(text("out"), HasSubstr("added pressure in the earthquake after Westergaard"));
  EXPECT_LT(answer("a.json")["level_m"], 7.5);
}

TEST_F(Answers, AFactorThatIsNotThereHasItsReason) {
  write("s.toml", block_on_rock(3, "friction_angle_deg = 50\n"));
  ASSERT_EQ(ask("safety s.toml --set joint.friction_angle_deg=0"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("as it stands: no factor: no shear strength of the joints would hold"));
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

TEST_F(Answers, AnUnnamedJointHasOneNameAndItsUpliftWhateverTheCommandAndTheOrder) {
  for (const bool rock_first : {true, false}) {
    write("s.toml", block_on_rock(3, "friction_angle_deg = 50\n", rock_first));
    ASSERT_EQ(ask("safety s.toml --json a.json"), 0) << text("out");
    const json joints = answer("a.json")["load_cases"][0]["joints"];
    ASSERT_EQ(joints.size(), 1U);
    EXPECT_EQ(joints[0]["name"], "b on rock");
    EXPECT_NEAR(joints[0]["uplift_n_per_m"].get<double>(), 0.5 * 9810 * 6 * 3, 1);
    ASSERT_EQ(ask("level s.toml --json a.json"), 0) << text("out");
    EXPECT_EQ(answer("a.json")["joint"], "b on rock");
    EXPECT_EQ(answer("a.json")["limit_analysis"]["mechanism"]["joints"][0], "b on rock");
  }
}

TEST_F(Answers, ABondThatHoldsByItsTensionIsWarnedOfWithoutARun) {
  const std::string law = "friction_angle_deg = 50\ncohesion_pa = 30e3\ntension_strength_pa = 25e3\n";
  write("s.toml", block_on_rock(3, law));
  for (const std::string command : {"level s.toml", "safety s.toml --set water.upstream_level_m=8"}) {
    ASSERT_EQ(ask(command + " --json a.json"), 0) << text("out");
    EXPECT_THAT(text("out"), HasSubstr("the bond of joint \"b on rock\" holds by its tension"));
    EXPECT_THAT(text("out"), HasSubstr("blocks without a mesh bear up to three times as much"));
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

TEST_F(Answers, ARunTellsItsFactorByLimitAnalysisWhetherItStandsOrFails) {
  const double at_limit = std::pow(6.99964615, 2);  // thrust and normal force are those of the head alone
  for (const double head_m : {6.0, 7.5}) {
    ASSERT_EQ(ask("run " + cases + "cracked-dam-upper --quiet --set analysis.duration_s=1 --out r" +
                  fmt::format("{} --set water.upstream_level_m={}", head_m, 15 + head_m)),
              0)
        << text("out");
    const json summary = answer(fmt::format("r{}/summary.json", head_m));
    const json& found = summary["limit_analysis"];
    EXPECT_EQ(summary["outcome"], head_m < 7 ? "stands" : "fails");
    EXPECT_EQ(found["factor"].get<double>() > 1, head_m * head_m < at_limit) << found.dump(1);
    EXPECT_EQ(found["level_m"], 15 + head_m);
    EXPECT_EQ(found["mechanism"]["joints"], json::array({"crack"}));
    EXPECT_THAT(text("out"), HasSubstr("\nFACTOR  "));
    ASSERT_EQ(ask(fmt::format("safety r{0}/scene.toml --out s{0} --json a.json", head_m)), 0) << text("out");
    EXPECT_EQ(answer("a.json")["load_cases"][0]["limit_analysis_factor"], found["factor"]);
  }
}

TEST_F(Answers, WhatNoStrengthHoldsTellsTheShareOfTheReservoirThatItBears) {
  write("s.toml", block_on_rock(1, "friction_angle_deg = 80\n"));
  ASSERT_EQ(ask("run s.toml --quiet --out r"), 0) << text("out");
  const json found = answer("r/summary.json")["limit_analysis"];
  EXPECT_TRUE(found["factor"].is_null()) << found.dump(1);
  EXPECT_LT(found["reservoir_factor"].get<double>(), 1);
  EXPECT_EQ(found["mechanism"]["mode"], "overturning");
}

TEST_F(Answers, ARunOnShakenGroundHasNoFactorOfLimitAnalysis) {
  ASSERT_EQ(ask("run " + cases + "shaken-incline --quiet --out r"), 0) << text("out");
  EXPECT_FALSE(answer("r/summary.json").contains("limit_analysis"));
}

TEST_F(Answers, WhatIsWrongIsToldBeforeAnythingIsWritten) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") +
                      "\n[[load_case]]\nname = 'flood'\nset = ['water.upstrem_level_m=3']\n");
  for (const std::string command : {"safety s.toml --out o", "check s.toml"}) {
    EXPECT_EQ(ask(command), 2);
    EXPECT_THAT(text("out"), HasSubstr("[[load_case]] \"flood\" sets water.upstrem_level_m=3: unknown key"));
    EXPECT_THAT(text("out"), HasSubstr("did you mean \"upstream_level_m\"?"));
  }
  EXPECT_FALSE(fs::exists(folder / "o"));
  EXPECT_EQ(ask("level " + cases + "water-column --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("model = \"column\" in [fluid]; expected a reservoir with a level"));
  EXPECT_EQ(ask("level " + cases + "hydrostatic-wall --set block.1.fixed=true --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("all blocks are fixed"));
  EXPECT_FALSE(fs::exists(folder / "o"));
  fs::create_directories(folder / "mine");
  write("mine/letter.txt", "dear");
  EXPECT_EQ(ask("level " + cases + "monolith-slides --out mine"), 2);
  EXPECT_THAT(text("out"), HasSubstr("found a folder that holds something else"));
  EXPECT_EQ(ask("level " + cases + "monolith-slides --json nowhere/a.json"), 2);
}

}  // namespace
}  // namespace blockweir::test
