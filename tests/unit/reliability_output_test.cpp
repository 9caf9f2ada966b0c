// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_reliability
// How the answer of `reliability` is told.
#include "bridge/reliability/reliability_output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <tuple>

#include "bridge/picture/draw.hpp"
#include "bridge/reliability/capacities.hpp"
#include "bridge/reliability/contradiction.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::study::reliability_output_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using SobolFigure = test::OwnFolder;

json answer_with(double first, double total) {
  return {{"by", "limit"},
          {"sampling", "monte-carlo"},
          {"level_m", 5},
          {"variables", {"phi"}},
          {"samples",
           {{"count", 10},
            {"probability", 0.1},
            {"interval", {0, 0.3}},
            {"index", 1.3},
            {"that_stand", 0},
            {"that_never_stand", 0},
            {"without_answer", 0},
            {"made", 0}}},
          {"sobol", {{"first", {first}}, {"total", {total}}, {"evaluations", 400}}}};
}

TEST(ReliabilityTold, ASobolShareInAllBelowThatAloneIsSaidToBeNoise) {
  EXPECT_THAT(reliability_text(answer_with(0.998, 0.945)),
              HasSubstr("where it is, by up to 0.053, that is the noise of 400 samples;"));
  EXPECT_THAT(reliability_text(answer_with(0.945, 0.998)), Not(HasSubstr("noise")));
}

TEST(ReliabilityTold, ALevelThatMostSamplesHaveIsNamedInPlaceOfADistribution) {
  json answer = answer_with(0.998, 0.99);
  answer["fit"] = {{"samples", 10}, {"mean", 36.5}, {"deviation", 0.8}, {"distribution", "Normal"}};
  EXPECT_THAT(reliability_text(answer), HasSubstr("Normal fits them best"));
  answer["fit"]["commonest"] = {{"level_m", 36.6882}, {"samples", 9}};
  EXPECT_THAT(reliability_text(answer), HasSubstr("9 of the 10 are 36.6882 m: no common distribution fits them\n"));
  EXPECT_THAT(reliability_text(answer), Not(HasSubstr("Normal")));
}

TEST(ReliabilityTold, TheCommonestLevelIsThatOfMostFiniteOnes) {
  const double infinite = std::numeric_limits<double>::infinity();
  const Capacities capacities({infinite, 3, 5.00001, 5, 7, infinite, infinite, infinite, std::nan("")}, 1);
  const auto [level_m, count] = capacities.commonest();
  EXPECT_NEAR(level_m, 5, 1e-4);
  EXPECT_EQ(count, 2U);
}

/// Beside whatever interval: FORM takes the limit state to be a plane.
TEST(ReliabilityTold, AFormOutsideTheIntervalOfTheSamplesIsSaidSo) {
  json answer = answer_with(0.998, 0.99);
  answer.erase("sobol");
  answer["form"] = {{"probability", 0.2}, {"index", 0.8}, {"design_point", {1}}, {"importance", {1}}, {"residual", 0}};
  answer["sorm"] = {{"breitung", {{"probability", 0.31}, {"index", 0.5}}}};
  for (const double p : {0.0, 0.1, 0.3, 0.3001, 0.9}) {
    answer["form"]["probability"] = p;
    const std::string text = reliability_text(answer);
    const std::string line = "outside the samples' interval, 0 to 0.3 (95 %)";
    const auto form = text.find("FORM");
    const auto sorm = text.find("SORM");
    ASSERT_LT(form, sorm) << text;
    EXPECT_EQ(text.substr(form, sorm - form).find(line) != std::string::npos, p > 0.3) << text;
    EXPECT_NE(text.find(line, sorm), std::string::npos) << text;
  }
}

TEST(ReliabilityTold, MethodsThatAreApartTenfoldDoNotAgree) {
  json answer = answer_with(0.998, 0.99);
  answer.erase("sobol");
  const json level = {{"level_m", 8.4}, {"trouble", ""}, {"outcome", "fails"}};
  answer["comparison"] = {{{"where", "at the means"}, {"limit", level}, {"statics", level}}};
  answer["form"] = {{"probability", 1e-9}, {"at_most", 1e-8}};
  for (const auto& [from, to, apart] : {std::tuple(1e-10, 1e-9, false), std::tuple(9e-8, 1e-6, false),
                                        std::tuple(2e-7, 1e-6, true), std::tuple(0.0, 9e-11, true)}) {
    answer["subset"] = {{"interval", {from, to}}};
    EXPECT_EQ(!contradiction_of(answer).empty(), apart) << from;
  }
  EXPECT_EQ(contradiction_of(answer),
            "P is 9e-11 or less by subset sampling, and 1e-09 or more by FORM: one of them misses a way to fail; take "
            "the larger, and raise method_samples");
  answer.erase("form");
  answer.erase("subset");
  EXPECT_THAT(reliability_text(answer), HasSubstr("AGREE   at the means"));
  answer["contradiction"] = "P is this and that";
  EXPECT_THAT(reliability_text(answer), HasSubstr("DIFFER  P is this and that\n        at the means"));
}

TEST(ReliabilityTold, FormNamesOtherWaysToFail) {
  json answer = answer_with(0.998, 0.99);
  answer.erase("sobol");
  answer["form"] = {{"probability", 0.2}, {"index", 0.8}, {"design_point", {1}}, {"importance", {1}}, {"residual", 0}};
  answer["form"]["further"] = {{{"probability", 0.1}, {"index", 1.2}, {"design_point", {3}}}};
  answer["form"]["at_most"] = 0.3;
  answer["form"]["without_effect_at_means"] = {0};
  EXPECT_THAT(reliability_text(answer),
              HasSubstr("        another: phi = 3; P 0.1\n        each is a way to fail: P of all together is at most "
                        "0.3\n        without effect at the means, where another way to fail governs: phi\n"));
  for (const auto& [outcome, words] : {std::pair("stands", "it stands at each level that is looked at"),
                                       std::pair("does not stand empty", "it does not stand empty")}) {
    const json found = {{"level_m", nullptr}, {"trouble", ""}, {"outcome", outcome}};
    answer["comparison"] = {{{"where", "at the means"}, {"limit", found}, {"statics", found}}};
    EXPECT_THAT(reliability_text(answer),
                HasSubstr(fmt::format("without effect at the means, where {}: phi\n", words)));
  }
}

/// Each name has a height of its own in the picture.
TEST_F(SobolFigure, HasNamesThatDoNotOverlap) {
  const std::vector<std::string> names = {"cut.lift joint.friction_angle_deg", "material.masonry.density_kg_per_m3",
                                          "joint.cohesion_pa"};
  const json answer = {{"variables", names}, {"sobol", {{"first", {0.9, 0.05, 0}}, {"total", {0.95, 0.1, 0}}}}};
  picture::draw({{folder / "s.svg", 800, 600, sobol_figure(answer)}});
  std::ifstream stream(folder / "s.svg");
  const std::string svg(std::istreambuf_iterator<char>(stream), {});
  std::set<std::string> heights;
  for (const std::string& name : names) {
    const std::size_t at = svg.find(name);
    ASSERT_NE(at, std::string::npos) << svg;
    const std::size_t comma = svg.find(',', svg.rfind("translate(", at));
    heights.insert(svg.substr(comma, svg.find(')', comma) - comma));
  }
  EXPECT_EQ(heights.size(), names.size());
}

}  // namespace
}  // namespace blockweir::study::reliability_output_test
