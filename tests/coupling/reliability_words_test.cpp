// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent nlohmann_json::nlohmann_json
// What blockweir reliability says of answers that are no whole ones, and of what would have no effect.
#include <cmath>

#include "tests/independent/upper_crack.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::reliability_words_test {
namespace {

using independent::UncertainCrack;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class ReliabilityWords : public Processes {
 protected:
  [[nodiscard]] int reliability(const UncertainCrack& crack, const std::string& tables,
                                const std::string& options = "") const {
    std::ofstream(folder / "scene.toml") << crack.scene() << tables;
    return shell(programs + "/blockweir reliability scene.toml --out r " + options);
  }
  [[nodiscard]] json answer() const { return json::parse(text("r/reliability.json")); }
};

TEST_F(ReliabilityWords, LevelsAreOfTheSamplesThatFailAndFormLeavesTheCrestWhereTheMeansStand) {
  const UncertainCrack crack{.friction_deg = {49.5, 4}};
  EXPECT_EQ(reliability(crack, "[reliability]\nlevel_m = 21.5\nsamples = 60\nmethods = ['form', 'sorm']\n"), 0);
  const json found = answer();
  const int stand = found["samples"]["that_stand"];
  ASSERT_GT(stand, 0);
  EXPECT_EQ(found["fit"]["samples"], 60 - stand);
  EXPECT_EQ(found["fit"]["cut_off_m"], 27);
  EXPECT_THAT(text("out"), HasSubstr("LEVELS  of failure of the " + std::to_string(60 - stand) +
                                     " of 60 samples that fail below the highest level: mean"));
  EXPECT_THAT(text("out"), HasSubstr("WARNING they are cut off at 27 m: with the " + std::to_string(stand) +
                                     " samples that stand there the mean is higher"));
  const double exact = crack.below(21.5 - 15);  // of one variable the first order is all
  EXPECT_NEAR(found["form"]["probability"].get<double>() / exact, 1, 1e-4);
  EXPECT_THAT(text("out"), HasSubstr("AGREE   at the means; limit analysis: stands; static analysis of the blocks: "
                                     "stands"));
}

TEST_F(ReliabilityWords, FormSaysWhyItFindsNoneWhereNothingFails) {
  EXPECT_EQ(
      reliability({.friction_deg = {80, 0.5}}, "[reliability]\nlevel_m = 21.5\nsamples = 10\nmethods = ['form']\n"), 1);
  EXPECT_THAT(text("out"), HasSubstr("NONE    by form: the search for the design point reached a point at which no "
                                     "variable changes the level; "));
  EXPECT_THAT(text("out"), HasSubstr("all points there stand at 27 m, the highest level that is looked at: "
                                     "may_overtop = true in [water]"));
}

/// Ties would be counted as a tenth of the points: probabilities came out up to 900 times too small.
TEST_F(ReliabilityWords, SubsetsHaveNoAnswerWhereMostPointsStandAtTheCrest) {
  const UncertainCrack crack{.friction_deg = {56, 4}};
  const std::string tables =
      "[reliability]\nlevel_m = 26\nsamples = 10\nmethod_samples = 400\nmethods = ['importance', 'subset']\n";
  EXPECT_EQ(reliability(crack, tables), 1);
  EXPECT_THAT(text("out"), HasSubstr("NONE    by subset: more than nine tenths of the points stand at the highest "
                                     "level that is looked at"));
  const double exact = crack.below(26 - 15);
  EXPECT_LE(answer()["importance"]["interval"][0], exact);
  EXPECT_GE(answer()["importance"]["interval"][1], exact);
  EXPECT_EQ(reliability(crack, tables, "--set water.may_overtop=true"), 0) << text("out");
  EXPECT_NEAR(std::log2(answer()["subset"]["probability"].get<double>() / exact), 0, 1);
}

TEST_F(ReliabilityWords, ADrawThatTheSceneRefusesIsNamedAndTheNextMethodIsAsked) {
  const UncertainCrack crack{.friction_deg = {30, 0.5}, .cohesion_pa = {4e3, 1.2e3}};
  EXPECT_EQ(
      reliability(
          crack, "[reliability]\nlevel_m = 22\nsamples = 10\nmethod_samples = 400\nmethods = ['importance', 'form']\n"),
      1);
  EXPECT_THAT(text("out"), HasSubstr("NONE    by importance: [[random]] \"cohesion\" draws -"));
  EXPECT_THAT(text("out"), HasSubstr("expected a number of at least 0; cut its distribution off with least or most"));
  EXPECT_THAT(text("out"), HasSubstr("FORM    P "));
  EXPECT_THAT(text("out"), Not(HasSubstr("has ended before it answered")));
  EXPECT_THAT(text("out"), HasSubstr("0.043 % of the values that are drawn are refused, as [[random]] \"cohesion\""));
  EXPECT_EQ(shell(programs + "/blockweir check scene.toml"), 0);
  EXPECT_THAT(text("out"), HasSubstr("warning: 0.043 % of the values that are drawn are refused, as [[random]] "
                                     "\"cohesion\" sets joints.crack.cohesion_pa=-"));
  EXPECT_EQ(shell(programs + "/blockweir check scene.toml --set random.1.least=0"), 0);
  EXPECT_THAT(text("out"), HasSubstr("sound; "));
}

TEST_F(ReliabilityWords, ACorrelationMakesImportanceAnotherAndLeavesSobolOut) {
  const UncertainCrack crack{.cohesion_pa = {20e3, 4e3}};
  EXPECT_EQ(reliability(crack,
                        "[[correlation]]\nbetween = ['friction', 'cohesion']\ncoefficient = -0.5\n"
                        "[reliability]\nlevel_m = 23\nsamples = 10\n"),
            0)
      << text("out");
  EXPECT_THAT(text("out"), HasSubstr("importance y^2/|y|^2, not alpha^2: friction = "));
  const json form = answer()["form"];
  const double friction = (form["design_point"][0].get<double>() - 30) / 2;
  const double cohesion = (form["design_point"][1].get<double>() - 20e3) / 4e3;
  const double share = friction * friction / (friction * friction + cohesion * cohesion);
  EXPECT_NEAR(form["importance"][0].get<double>(), share, 1e-6);
  EXPECT_FALSE(answer().contains("sobol"));
}

/// The block is tied to the base: limit analysis lets it stand up to the crest, and neither higher levels nor another
/// method would show that its anchor stretches.
TEST_F(ReliabilityWords, WhereAnchorsHoldAnyForceTheyAreTheCauseAndStaticsTheRemedy) {
  const std::string anchor =
      "[[bolt]]\nname = 'anchor'\nfrom_block = 'top'\nfrom_m = [3, 20]\nto_block = 'base'\nto_m = [3, 5]\n"
      "youngs_modulus_pa = 200e9\narea_m2_per_m = 1e-3\nprestress_n_per_m = 0\n";
  const std::string cause = "in limit analysis anchors hold any force: state yield_n_per_m of each [[bolt]]";
  const std::string remedy = "; by = \"statics\" in [reliability] has anchors that stretch";
  EXPECT_EQ(reliability({}, anchor + "[reliability]\nlevel_m = 24\nsamples = 10\nmethods = ['form']\n"), 1);
  EXPECT_EQ(answer()["limit_analysis_note"], cause + remedy);
  EXPECT_THAT(text("out"), HasSubstr("DIFFER  at the means; limit analysis: stands; static analysis"));
  EXPECT_THAT(text("out"),
              HasSubstr("NONE    by form: all points there stand at 27 m, the highest level that is looked "
                        "at: " +
                        cause + remedy + "\n"));
  EXPECT_THAT(text("out"), HasSubstr("        " + cause + remedy + "\n"));
  EXPECT_THAT(text("out"), Not(HasSubstr("may_overtop")));
  EXPECT_EQ(
      reliability({}, anchor + "yield_n_per_m = 1e4\n[reliability]\nlevel_m = 24\nsamples = 10\nmethods = ['form']\n"),
      0)
      << text("out");
  EXPECT_THAT(text("out"), Not(HasSubstr("hold any force")));
}

/// The lift governs at the means, and is certain; the base fails at the level asked for.
TEST_F(ReliabilityWords, AnotherJointThanAtTheMeansIsTold) {
  std::ofstream(folder / "scene.toml") << R"(analysis = { duration_s = 1 }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
water = { upstream_level_m = 7.5 }
block = [{ name = "rock", material = "m", fixed = true, vertices_m = [[-20, -6], [25, -6], [25, 0], [-20, 0]] },
  { name = "lower", material = "m", vertices_m = [[0, 0], [6, 0], [4, 4], [0, 4]] },
  { name = "upper", material = "m", vertices_m = [[0, 4], [4, 4], [2, 10], [0, 10]] }]
joints = [{ name = "base", between = ["rock", "lower"], friction_angle_deg = 40 },
  { name = "lift", between = ["lower", "upper"], friction_angle_deg = 20 }]
random = [{ name = "phi base", key = "joints.base.friction_angle_deg", distribution = "normal", mean = 40, deviation = 3 },
  { name = "phi lift", key = "joints.lift.friction_angle_deg", distribution = "normal", mean = 20, deviation = 0 }]
reliability = { level_m = 8.4, samples = 100, method_samples = 300, methods = ["form", "importance", "subset"] }
)";
  const std::string command = programs + "/blockweir reliability scene.toml --out r --set random.1.deviation=";
  EXPECT_EQ(shell(command + "0.2"), 1) << text("out");
  EXPECT_NEAR(answer()["form"]["index"].get<double>(), (40 - 21.982) / 3, 1e-3);
  EXPECT_THAT(text("out"), HasSubstr("without effect at the means, where another way to fail governs: phi base"));
  EXPECT_THAT(text("out"), HasSubstr("NONE    by subset: its points miss the design point (21.982, 20)"));
  EXPECT_GT(answer()["importance"]["interval"][0], 1e-10);
  EXPECT_EQ(shell(command + "1e-9 --set 'reliability.methods=[\"none\"]'"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("100 of the 100 are 9.48969 m: no common distribution fits them"));
}

TEST_F(ReliabilityWords, AnOverrideOfWhatIsDrawnIsRefused) {
  EXPECT_EQ(reliability({}, "", "--set joints.0.friction_angle_deg=10"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--set joints.0.friction_angle_deg=10: error: [[random]] \"friction\" draws this "
                                     "key, so that it would have no effect"));
  EXPECT_THAT(text("out"), HasSubstr("as --set random.0.KEY=VALUE does"));
}

}  // namespace
}  // namespace blockweir::test::reliability_words_test
