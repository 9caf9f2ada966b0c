// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json fmt::fmt
// The factor of safety and the table of joints as a user gets them: blockweir safety.
#include <map>

#include "tests/coupling/answers.hpp"

namespace blockweir::test::safety_answers_test {
namespace {

using testing::HasSubstr;

TEST_F(Answers, TellAFactorBelowOneOfWhatFails) {
  ASSERT_EQ(ask("safety " + cases + "monolith-slides --json a.json --set water.upstream_level_m=7.9"), 0)
      << text("out");
  const json found = answer("a.json")["load_cases"][0];
  EXPECT_EQ(found["outcome"], "fails");
  EXPECT_LT(found["factor"], 1);
  EXPECT_GT(found["factor"], 0.9);
  EXPECT_NEAR(found["factor"].get<double>() / found["limit_analysis_factor"].get<double>(), 1, 1e-5);
}

TEST_F(Answers, AFactorThatIsNotThereHasItsReason) {
  write("s.toml", block_on_rock(3, "friction_angle_deg = 50\n"));
  ASSERT_EQ(ask("safety s.toml --set joint.friction_angle_deg=0"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("scene as written: no factor: no shear strength of the joints would hold"));
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
  EXPECT_THAT(text("out"), HasSubstr("N effective normal force (U is deducted)"));
  const json found = answer("a.json")["load_cases"][0];
  EXPECT_NEAR(found["factor"], 1.2611, 1e-4);
  EXPECT_NEAR(found["limit_analysis_factor"], 1.2611, 1e-4);
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
  const double westergaard = 7.0 / 12 * 0.02 * 9810 * (16 + 1);  // on upright faces, of both pools
  EXPECT_NEAR(sums["added water (Westergaard)"]["x_n_per_m"].get<double>() / westergaard, 1, 1e-6);
  EXPECT_EQ(found["tailwater_m"], 1);
  EXPECT_THAT(
      text("out"),
      HasSubstr(
          "times [silt] and the inertia of [earthquake], by limit analysis; held as stated: weight, water, ice and"));
  EXPECT_THAT(text("out"), HasSubstr("scene as written: tailwater at 1 m"));
  EXPECT_THAT(text("out"), HasSubstr("moments about (3.5, 0) m"));
}

}  // namespace
}  // namespace blockweir::test::safety_answers_test
