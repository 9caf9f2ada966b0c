// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// blockweir report: one page that a browser opens without an error and a reader can use.
#include "tests/coupling/report_page.hpp"

namespace blockweir::test::report_test {
namespace {

using testing::HasSubstr;

TEST_F(Report, OpensInABrowserAndCanBeUsed) {
  write_scene();
  std::ofstream(folder / "wall.toml", std::ios::app) << R"([[random]]
name = "friction"
key = "joint.friction_angle_deg"
distribution = "normal"
mean = 30
deviation = 2
least = 20
[[random]]
name = "density"
key = "material.masonry.density_kg_per_m3"
distribution = "triangular"
from = 2200
peak = 2300
to = 2350
[reliability]
samples = 200
method_samples = 50
)";
  ASSERT_EQ(shell(programs + "/blockweir report wall.toml --out wall.html"), 0) << text("out");
  EXPECT_LT(fs::file_size(folder / "wall.html"), 2'000'000U);
  EXPECT_EQ(text("wall.html").find("src="), std::string::npos) << "the page needs other files";
  const nlohmann::json seen = opened("wall.html");
  ASSERT_TRUE(seen.is_object()) << text("out") << text("browser.log");
  EXPECT_THAT(seen["faults"], testing::IsEmpty()) << seen["faults"];
  for (const char* use : {"steps_on", "steps_back", "scrubs", "plays", "zooms_all", "shows_all", "linked"}) {
    EXPECT_TRUE(seen[use].get<bool>()) << use;
  }
  ASSERT_EQ(seen["chapters"].size(), 9U);
  EXPECT_EQ(seen["chapters"][4], "5 Reliability");
  EXPECT_THAT(seen["reliability"].get<std::string>(),
              testing::AllOf(HasSubstr("FORM"), HasSubstr("normal, mean 30, deviation 2, at least 20"),
                             HasSubstr("at the design point"), HasSubstr("Sobol"), HasSubstr("Fragility curve")));
  EXPECT_EQ(seen["fragility"], 1);
  EXPECT_THAT(seen["verdict"].get<std::string>(), HasSubstr("Probability of failure at a level of 4.4 m: "));
  EXPECT_THAT(seen["verdict"].get<std::string>(), HasSubstr("The structure FAILS"));
  EXPECT_THAT(seen["verdict"].get<std::string>(), HasSubstr("Load cases: 1 of 1 reach their required factor."));
  EXPECT_THAT(seen["joints"].get<std::string>(), testing::AllOf(HasSubstr("low water"), HasSubstr("a guideline")));
  EXPECT_THAT(seen["level"].get<std::string>(), HasSubstr("limit analysis"));
  EXPECT_THAT(seen["scene"].get<std::string>(), HasSubstr("a wall </script><b>holds</b> a pond"));
  EXPECT_GE(seen["mechanism"].get<int>(), 3);
  EXPECT_EQ(seen["states"], 3) << "the section, and one for each load case";
  EXPECT_EQ(seen["labels_apart"], true);
  EXPECT_THAT(seen["section"].get<std::string>(),
              testing::AllOf(HasSubstr("water upstream"), HasSubstr("uplift in base"), HasSubstr("point load 1 kN/m"),
                             HasSubstr("(0.5, 5) in wall"), HasSubstr("force kN/m: low water")));
}

TEST_F(Report, HasTheWarningsOfEveryLoadCaseOnceAtTheVerdict) {
  write_scene();
  std::ofstream(folder / "wall.toml", std::ios::app) << R"([[load_case]]
name = "glued"
set = ["joints.base.cohesion_pa=60e3", "water.upstream_level_m=4.5"]
[[load_case]]
name = "glued and fuller"
set = ["joints.base.cohesion_pa=60e3", "water.upstream_level_m=4.9"]
[[load_case]]
name = "full of silt"
set = ["silt.level_m=5", "silt.submerged_density_kg_per_m3=400", "silt.pressure_coefficient=0.4", "water.density_kg_per_m3=2100"]
)";
  ASSERT_EQ(shell(programs + "/blockweir report wall.toml --out wall.html"), 0) << text("out");
  const nlohmann::json seen = opened("wall.html");
  ASSERT_TRUE(seen.is_object()) << text("out") << text("browser.log");
  const std::string said = seen["verdict"];
  EXPECT_THAT(said, HasSubstr("Warning, load case \"glued\": joint \"base\" has no tension_strength_pa"));
  EXPECT_THAT(said, testing::ContainsRegex("joint \"base\" is in tension over [0-9.]+ to 82.4 % of its length"))
      << "the worst of the load cases is seen";
  EXPECT_THAT(said, HasSubstr("Warning, load case \"full of silt\": "));
  EXPECT_THAT(said, HasSubstr("density_kg_per_m3 in [water] is 2100 kg/m3, which is unusual"));
  const std::string cases = seen["joints"];
  EXPECT_THAT(cases, HasSubstr("of this chapter: see chapter 1"));
  EXPECT_THAT(cases, HasSubstr("Silt, ice and earthquakeload casesilt up to msubmerged kg/m3Kscene as written---"));
  EXPECT_THAT(cases, HasSubstr("full of silt54000.4"));
  EXPECT_THAT(cases, testing::Not(HasSubstr("ice thrust"))) << "no case has ice";
  EXPECT_THAT(cases, HasSubstr("The resultant lies in the middle third of the level joint \"base\"."));
  EXPECT_THAT(cases,
              HasSubstr("The resultant lies outside the middle third of 1 of 1 level joint: \"base\" (downstream "
                        "of it)."));
  EXPECT_THAT(seen["section"].get<std::string>(), HasSubstr("bonded mwater in itbase3030"));
  EXPECT_THAT(seen["joints"].get<std::string>(), testing::Not(HasSubstr("which is unusual")));
}

/// The factor on the water is not that of the mechanism that is drawn; nor is the section's frame the failure's moment.
TEST_F(Report, SaysWhichMechanismAndWhichMomentItDraws) {
  write_scene();
  std::ofstream(folder / "wall.toml", std::ios::app) << R"([[load_case]]
name = "pushed over"
set = ["point_load.0.force_n_per_m=[500e3, 0]"]
[output]
frame_every_s = 0.17
)";
  ASSERT_EQ(shell(programs + "/blockweir report wall.toml --out wall.html"), 0) << text("out");
  const nlohmann::json seen = opened("wall.html");
  ASSERT_TRUE(seen.is_object()) << text("out") << text("browser.log");
  EXPECT_THAT(
      seen["joints"].get<std::string>(),
      testing::ContainsRegex("Mechanism of [^.]*pushed over[^.]*, by limit analysis: .*turns over.*As no strength "
                             "holds it, this is the mechanism with the largest power"));
  EXPECT_THAT(seen["section"].get<std::string>(),
              testing::ContainsRegex("with what acts at [0-9.]+ s, the last frame before the failure at [0-9.]+ s"));
}

TEST_F(Report, WhatStandsWithALoadCaseThatMissesItsFactorIsNoPlainYes) {
  write_scene();
  std::string scene = text("wall.toml");
  scene.replace(scene.find("{ from = 4, rate_per_s = 0.1 }"), 30, "2");
  std::ofstream(folder / "wall.toml")
      << scene
      << "[[load_case]]\nname = \"high water\"\nset = "
         "[\"water.upstream_level_m=4\"]\nrequired_factor = 1.5\nsource = \"a guideline\"\n";
  ASSERT_EQ(shell(programs + "/blockweir report wall.toml --out wall.html"), 0) << text("out");
  const nlohmann::json seen = opened("wall.html");
  ASSERT_TRUE(seen.is_object()) << text("out") << text("browser.log");
  EXPECT_THAT(seen["verdict"].get<std::string>(),
              HasSubstr("The structure STANDS, but 1 of its load cases does not reach the required factor"));
  EXPECT_EQ(seen["outcome_class"], "outcome short");
}

/// A joint that bends has no sliding factor, and may govern all the same.
TEST_F(Report, TheVerdictBeginsWithTheJointThatGoverns) {
  std::ofstream(folder / "bent.toml") << R"(analysis = { duration_s = 1, rigid = "all", kind = "static" }
water = { upstream_level_m = 17 }
joint = { friction_angle_deg = 45, uplift = "triangular" }
material.concrete = { youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
[[block]]
name = "rock"
material = "concrete"
fixed = true
vertices_m = [[-30, -10], [50, -10], [50, -1], [17, -1], [8, 0], [-30, 0]]
[[block]]
name = "foot"
material = "concrete"
vertices_m = [[0, 0], [8, 0], [17, -1], [10.5, 8], [0, 8]]
[[block]]
name = "head"
material = "concrete"
vertices_m = [[0, 8], [10.5, 8], [3, 20], [0, 20]]
[[joints]]
name = "base"
between = ["rock", "foot"]
[[joints]]
name = "lift"
between = ["head", "foot"]
)";
  ASSERT_EQ(shell(programs + "/blockweir report bent.toml --out bent.html"), 0) << text("out");
  const nlohmann::json seen = opened("bent.html");
  ASSERT_TRUE(seen.is_object()) << text("out") << text("browser.log");
  EXPECT_THAT(seen["verdict"].get<std::string>(),
              testing::ContainsRegex(
                  "STANDS *\n? *The lowest factor of safety [^:]*: of the scene as written at a level of 17 m, by "
                  "[^.]*.The lowest factor on the water .*Factor by limit analysis: .*slide on joint \"base\".*Of "
                  "joints that run "
                  "straight through the structure: .*on joint \"lift\""));
}

/// A load case with `set = []`, and the scene as written, are one row, one table and one picture.
TEST_F(Report, ShowsALoadCaseThatIsTheSceneAsWrittenOnce) {
  write_scene();
  for (const char* name : {"usual", "usual, long"}) {
    std::ofstream(folder / "wall.toml", std::ios::app)
        << "[[load_case]]\nname = '" << name
        << "'\nclass = 'usual'\nset = []\nrequired_factor = 1.2\nsource = 'a guideline'\n";
  }
  ASSERT_EQ(shell(programs + "/blockweir run wall.toml --out r --quiet"), 0) << text("out");
  ASSERT_EQ(shell(programs + "/blockweir report r"), 0) << text("out");
  const nlohmann::json seen = opened("r/report.html");
  ASSERT_TRUE(seen.is_object()) << text("out").substr(0, 4000);
  const std::string cases = seen["joints"];
  const auto counted = [&cases](const std::string& words) {
    long count = 0;
    for (std::size_t at = 0; (at = cases.find(words, at)) != std::string::npos; at += words.size()) ++count;
    return count;
  };
  EXPECT_EQ(counted("scene as written"), 0) << cases;
  EXPECT_EQ(counted("Joints: usual"), 1) << cases;
  EXPECT_EQ(counted("Joints: low water"), 1) << cases;
  EXPECT_GE(counted("usual, long"), 1) << "it has its own row, with what it requires; " << cases;
  EXPECT_EQ(seen["states"], 3) << "the section, and one of each different load case";
  EXPECT_EQ(seen["faults"], nlohmann::json::array());
}

TEST_F(Report, ShowsTheLevelAskedForFarFromTheCurve) {
  write_scene();
  std::ofstream(folder / "wall.toml", std::ios::app)
      << "[[random]]\nkey = 'joint.friction_angle_deg'\ndistribution = 'normal'\nmean = 30\ndeviation = 0.1\n"
         "[reliability]\nsamples = 100\nmethods = ['none']\n";
  ASSERT_EQ(shell(programs + "/blockweir report wall.toml --out wall.html"), 0) << text("out");
  const nlohmann::json seen = opened("wall.html");
  EXPECT_THAT(seen["reliability"].get<std::string>(), HasSubstr("Dashed red: the level that is asked for"));
  EXPECT_EQ(seen["asked_lines"], 1);
}

/// What decides is not left to a table further down, whichever way has found it.
TEST_F(Report, TheVerdictNamesTheLowestFactorAndJointsOfASetHaveTheirElevations) {
  std::ofstream(folder / "set.toml") << R"(analysis = { duration_s = 1, rigid = "all", kind = "static" }
water = { upstream_level_m = 4 }
joint = { friction_angle_deg = 40 }
material.m = { youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-30, -10], [50, -10], [50, 0], [-30, 0]]
[section]
material = "m"
outline_m = [[0, 0], [8, 0], [3, 10], [0, 10]]
[[joint_set]]
name = "lifts"
dip_deg = 2
spacing_m = 4
offset_m = 2
[[joint_set]]
name = "cross"
dip_deg = 88
spacing_m = 3
offset_m = 1
[[load_case]]
name = "flood"
set = ["water.upstream_level_m=8.5"]
)";
  ASSERT_EQ(shell(programs + "/blockweir report set.toml --out set.html"), 0) << text("out");
  const nlohmann::json seen = opened("set.html");
  ASSERT_TRUE(seen.is_object()) << text("out") << text("browser.log");
  EXPECT_THAT(
      seen["verdict"].get<std::string>(),
      testing::ContainsRegex("The lowest factor of safety of this report, on strength, is [0-9.]+: of load case "
                             "\"flood\" at a level of 8.5 m, by the statics of the blocks.The lowest factor on "
                             "the water is [0-9.]+: of load case \"flood\" at a level of 8.5 m, by limit"));
  EXPECT_THAT(seen["joints"].get<std::string>(), testing::ContainsRegex("lifts, [0-9.]+ to [0-9.]+ m"));
}

}  // namespace
}  // namespace blockweir::test::report_test
