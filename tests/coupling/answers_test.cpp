// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json fmt::fmt
// What the commands run, level and safety say alike: anchors, names of joints, bonds, factors, and what is wrong.
#include <cmath>

#include "tests/coupling/answers.hpp"

namespace blockweir::test::answers_test {
namespace {

using testing::HasSubstr;

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
  write("s.toml", scene + "yield_n_per_m = 151e3\n");
  ASSERT_EQ(ask("run s.toml --quiet --out hardly"), 0) << text("out");
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("anchors at their yield force"))) << "hardly above the prestress";
  write("s.toml", scene + "yield_n_per_m = 200e3\n");
  ASSERT_EQ(ask("run s.toml --quiet --out stronger"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("limit analysis takes anchors at their yield force"));
  const std::string cases = "[[load_case]]\nname = 'low'\nset = ['water.upstream_level_m=1']\n";
  write("cases.toml", scene + "yield_n_per_m = 200e3\n" + cases);
  ASSERT_EQ(ask("safety cases.toml --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("limit: limit analysis takes anchors at their yield force"));
  EXPECT_EQ(counted("limit analysis takes anchors at their yield force"), 1) << text("out");
  ASSERT_EQ(ask("level s.toml --out l --set joint.friction_angle_deg=16 --set bolt.a.to_m=[-7,-4] --set "
                "bolt.a.prestress_n_per_m=50e3"),
            0)
      << text("out");
  EXPECT_THAT(text("out"), HasSubstr("reason: limit analysis takes anchors at their yield force"));
  EXPECT_EQ(counted("limit analysis takes anchors at their yield force"), 1) << text("out");
  write("s.toml", scene);
  ASSERT_EQ(ask("run s.toml --quiet --out endless"), 0) << text("out");
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
}  // namespace blockweir::test::answers_test
