// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Answers without a run, as a user gets them: blockweir level, blockweir safety.
#include <fstream>

#include "tests/same_results.hpp"

namespace blockweir::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Answers : public SameResults {
 protected:
  [[nodiscard]] int ask(const std::string& words) const { return shell(programs + "/blockweir " + words); }
  [[nodiscard]] json answer(const std::string& file) const { return json::parse(text(file)); }
  void write(const std::string& name, const std::string& content) const { std::ofstream(folder / name) << content; }
};

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

TEST_F(Answers, LoadCasesHaveTheirFactorsAndSayWhetherTheyAreEnough) {
  const std::string scene = text(cases + "monolith-slides/scene.toml") +
                            "\n[[load_case]]\nname = 'weak'\nclass = 'unusual'\nset = ['joint.friction_angle_deg=10']\n"
                            "required_factor = 1.3\nsource = 'test'\n"
                            "[[load_case]]\nname = 'low water'\nset = ['water.upstream_level_m=3']\n"
                            "required_factor = 2\nsource = 'test'\n";
  write("s.toml", scene);
  ASSERT_EQ(ask("safety s.toml --out o --json a.json"), 0) << text("out");
  const json load_cases = answer("a.json")["load_cases"];
  ASSERT_EQ(load_cases.size(), 3U);
  EXPECT_EQ(load_cases[0]["name"], "as it stands");
  EXPECT_TRUE(load_cases[0]["satisfied"].is_null());
  EXPECT_EQ(load_cases[2]["satisfied"], true);
  for (const json& c : load_cases) {
    const double limit = c["limit_analysis_factor"];
    EXPECT_NEAR(c["factor"].get<double>() / limit, 1, 1e-5) << c["name"];
    ASSERT_EQ(c["joints"].size(), 1U) << c.dump();
  }
  // Rigid or not, one block on one joint has the factor that its sums give.
  const json& joint = load_cases[2]["joints"][0];
  EXPECT_NEAR(joint["sliding_factor"].get<double>() / load_cases[2]["limit_analysis_factor"].get<double>(), 1, 1e-5);
  EXPECT_TRUE(fs::exists(folder / "o/low-water/safety.json"));
  // On a level base the sums by hand are the joint's forces.
  double right = 0;
  double up = 0;
  for (const json& sum : joint["sums"]) {
    right += sum["x_n_per_m"].get<double>();
    up += sum["y_n_per_m"].get<double>();
  }
  const double weight = std::abs(joint["sums"][0]["y_n_per_m"].get<double>());  // the dam strains under its loads
  EXPECT_NEAR((up + joint["normal_n_per_m"].get<double>()) / weight, 0, 1e-6);
  EXPECT_NEAR((right - joint["shear_n_per_m"].get<double>()) / weight, 0, 1e-6);
  EXPECT_EQ(joint["sums"][0]["name"], "weight");
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

TEST_F(Answers, TheEarthquakesWaterIsToldToBeWestergaards) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") + "\n[earthquake]\nhorizontal_coefficient = 0.05\n");
  ASSERT_EQ(ask("level s.toml --json a.json"), 0) << text("out");
  EXPECT_EQ(answer("a.json")["added_water_pressure"], "Westergaard");
  EXPECT_THAT(text("out"), HasSubstr("added pressure in the earthquake after Westergaard"));
  EXPECT_LT(answer("a.json")["level_m"], 7.5);
}

TEST_F(Answers, ADrainBeyondItsJointInALoadCaseIsToldBeforeAnythingIsWritten) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") +
                      "\n[[load_case]]\nname = 'drained'\nset = ['joints.joint.uplift=\"drained\"', "
                      "'joints.joint.drain_m=99', 'joints.joint.drain_efficiency=0.5']\n");
  EXPECT_EQ(ask("safety s.toml --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("the drain of joint \"joint\" lies at 99 m"));
  EXPECT_FALSE(fs::exists(folder / "o"));
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
