// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json fmt::fmt
// Load cases as blockweir safety answers them: factors, what is required, and the exit status.
#include <cmath>

#include "tests/coupling/answers.hpp"

namespace blockweir::test::load_cases_test {
namespace {

using testing::HasSubstr;
using testing::Not;

class LoadCases : public Answers {};

TEST_F(LoadCases, LoadCasesHaveTheirFactorsAndSayWhetherTheyAreEnough) {
  const std::string scene = text(cases + "monolith-slides/scene.toml") +
                            "\n[[load_case]]\nname = 'weak'\nclass = 'unusual'\nset = ['joint.friction_angle_deg=10']\n"
                            "required_factor = 1.3\nsource = 'test'\n"
                            "[[load_case]]\nname = 'low water'\nset = ['water.upstream_level_m=3']\n"
                            "required_factor = 2\nsource = 'test'\n";
  write("s.toml", scene);
  ASSERT_EQ(ask("safety s.toml --out o --json a.json"), 1) << "'weak' has not what it requires; " << text("out");
  const json load_cases = answer("a.json")["load_cases"];
  ASSERT_EQ(load_cases.size(), 3U);
  EXPECT_EQ(load_cases[0]["name"], "scene as written");
  EXPECT_TRUE(load_cases[0]["satisfied"].is_null());
  EXPECT_EQ(load_cases[2]["satisfied"], true);
  for (const json& c : load_cases) {
    const double limit = c["limit_analysis_factor"];
    EXPECT_NEAR(c["factor"].get<double>() / limit, 1, 1e-5) << c["name"];
    ASSERT_EQ(c["joints"].size(), 1U) << c.dump();
  }
  // Rigid or not, one block on one joint has the factor that its sums give, also where it does not stand.
  EXPECT_EQ(load_cases[1]["outcome"], "fails");
  EXPECT_TRUE(load_cases[1].contains("joints_with_strength_times"));
  EXPECT_THAT(text("out"), HasSubstr("as it does not stand (sliding and residual: with the strength as stated)"));
  for (const json& c : load_cases) {
    for (const char* strength : {"sliding_factor", "residual_sliding_factor"}) {
      const double of_sums = c["joints"][0][strength];
      EXPECT_NEAR(of_sums / c["limit_analysis_factor"].get<double>(), 1, 1e-5) << c["name"] << ' ' << strength;
    }
  }
  const json& joint = load_cases[2]["joints"][0];
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

TEST_F(LoadCases, TheSceneAsWrittenMayHaveAClassAndARequiredFactor) {
  write("s.toml",
        text(cases + "monolith-slides/scene.toml") +
            "\n[ice]\nthrust_n_per_m = 20e3\nthickness_m = 0.5\n"
            "[[load_case]]\nname = 'winter'\nclass = 'usual'\nset = []\nrequired_factor = 1.01\nsource = 'test'\n"
            "[[load_case]]\nname = 'summer'\nset = ['ice.thrust_n_per_m=0']\n");
  ASSERT_EQ(ask("check s.toml --set water.upstream_level_m=3 --set expect=[] --set variant=[]"), 0) << text("out");
  EXPECT_THAT(text("out"), Not(HasSubstr("changes nothing")));
  ASSERT_EQ(ask("safety s.toml --json a.json --set water.upstream_level_m=3 --set expect=[] --set variant=[]"), 0)
      << text("out");
  const json load_cases = answer("a.json")["load_cases"];
  EXPECT_EQ(load_cases[1]["satisfied"], true);
  EXPECT_EQ(load_cases[1]["factor"], load_cases[0]["factor"]);
  EXPECT_EQ(load_cases[1]["name"], "winter");
  EXPECT_THAT(text("out"), Not(HasSubstr("joints that run through, winter"))) << "the table of the scene as written";
  EXPECT_GT(load_cases[2]["factor"].get<double>(), load_cases[1]["factor"].get<double>());
  EXPECT_THAT(text("out"), Not(HasSubstr("changes nothing")));
}

TEST_F(LoadCases, ALoadCaseSetsItsKeysOverTheCommandLine) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") +
                      "\n[[load_case]]\nname = 'flood'\nset = ['water.upstream_level_m=7.9']\n");
  ASSERT_EQ(ask("safety s.toml --json a.json --set water.upstream_level_m=3"), 0) << text("out");
  const json load_cases = answer("a.json")["load_cases"];
  EXPECT_EQ(load_cases[0]["outcome"], "stands");
  EXPECT_EQ(load_cases[0]["level_m"], 3);
  EXPECT_EQ(load_cases[1]["outcome"], "fails");
  EXPECT_EQ(load_cases[1]["level_m"], 7.9);
  EXPECT_THAT(text("out"), HasSubstr("flood: WARNING --set water.upstream_level_m=3 is not what counts here: the load "
                                     "case sets water.upstream_level_m=7.9"));
  ASSERT_EQ(ask("safety s.toml --set joint.friction_angle_deg=20"), 0) << text("out");
  EXPECT_THAT(text("out"), Not(HasSubstr("is not what counts here")));
}

TEST_F(LoadCases, ADrainBeyondItsJointInALoadCaseIsToldBeforeAnythingIsWritten) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") +
                      "\n[[load_case]]\nname = 'drained'\nset = ['joints.joint.uplift=\"drained\"', "
                      "'joints.joint.drain_m=99', 'joints.joint.drain_efficiency=0.5']\n");
  EXPECT_EQ(ask("safety s.toml --out o --set expect=[]"), 2);
  EXPECT_THAT(text("out"), HasSubstr("the drain of joint \"joint\" lies at 99 m"));
  EXPECT_FALSE(fs::exists(folder / "o"));
}

/// With cohesion on all of the base the factor is 6.3, with that on the pressed half 4.3.
TEST_F(LoadCases, ALoadCaseIsJudgedByTheCohesionOfWhatIsNotInTension) {
  const std::string law = "friction_angle_deg = 45\ncohesion_pa = 300e3\n";
  write("s.toml", block_on_rock(3, law) +
                      "\n[[load_case]]\nname = 'high'\nset = ['water.upstream_level_m=7']\nrequired_factor = 5\n"
                      "source = 'test'\n[[load_case]]\nname = 'low'\nset = ['water.upstream_level_m=2']\n"
                      "required_factor = 5\nsource = 'test'\n");
  ASSERT_EQ(ask("safety s.toml --json a.json"), 1) << "'high' is not enough; " << text("out");
  const json high = answer("a.json")["load_cases"][1];
  EXPECT_GT(high["factor"], 5) << high.dump(1);
  EXPECT_LT(high["with_cracked_joint"]["factor"], 5);
  EXPECT_EQ(high["satisfied"], false);
  EXPECT_THAT(text("out"), HasSubstr("high: not enough: with cohesion on what is not in tension alone"));
  EXPECT_THAT(text("out"), HasSubstr("uplift = \"triangular\" takes it to be closed"));
  EXPECT_THAT(text("out"), HasSubstr("state uplift = \"cracked\""));
  const json low = answer("a.json")["load_cases"][2];
  EXPECT_EQ(low["satisfied"], true) << low.dump(1);
  EXPECT_FALSE(low.contains("with_cracked_joint"));
  EXPECT_THAT(low["warnings"], testing::IsEmpty());
}

TEST_F(LoadCases, ALoadCaseThatChangesNothingIsWarnedOf) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") +
                      "\n[[load_case]]\nname = 'idle'\nset = ['material.concrete.poissons_ratio=0.2']\n"
                      "[[load_case]]\nname = 'own name'\nset = ['load_case.idle.name=other']\n"
                      "[[load_case]]\nname = 'light'\nset = ['material.concrete.density_kg_per_m3=2.4']\n");
  const std::string idle =
      "[[load_case]] \"idle\" changes nothing: with material.concrete.poissons_ratio=0.2 the "
      "scene is the same";
  ASSERT_EQ(ask("safety s.toml"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("idle: WARNING " + idle));
  ASSERT_EQ(shell(programs + "/blockweir check s.toml"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("with load_case.idle.name=other the scene is the same"));
  EXPECT_THAT(text("out"),
              testing::AllOf(HasSubstr("warning: " + idle), Not(HasSubstr("\"light\" changes nothing")),
                             HasSubstr("[[load_case]] \"light\" sets material"), HasSubstr("if it is in t/m3")));
}

/// The forces that a load case states stand apart in the sums by hand.
TEST_F(LoadCases, SiltAndTheEarthquakeHaveSumsOfTheirOwnAndShakingIsSaidToBeLeftOut) {
  write("s.toml", text(cases + "monolith-slides/scene.toml") +
                      "\n[silt]\nlevel_m = 2\nsubmerged_density_kg_per_m3 = 900\npressure_coefficient = 0.4\n"
                      "[earthquake]\nhorizontal_coefficient = 0.01\n"
                      "[base_motion]\nacceleration_x_m_per_s2 = { table = [[0, 0], [0.1, 1], [0.2, 0]] }\n");
  const std::string left_out = "WARNING [base_motion] is left out of this static answer";
  ASSERT_EQ(ask("safety s.toml --json a.json"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr(left_out));
  std::vector<std::string> names;
  const json load_cases = answer("a.json")["load_cases"];
  for (const json& sum : load_cases[0]["joints"][0]["sums"]) names.push_back(sum["name"]);
  EXPECT_THAT(names, testing::IsSupersetOf({"weight", "silt", "inertia (earthquake)"}));
  EXPECT_THAT(names, Not(testing::Contains("loads")));
  ASSERT_EQ(ask("level s.toml"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr(left_out));
}

}  // namespace
}  // namespace blockweir::test::load_cases_test
