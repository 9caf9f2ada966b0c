// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_study
// The terminal's tables of `blockweir safety`: no name is cut off, and what has figures fits 80 columns.
#include "bridge/study/safety_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "bridge/study/safety.hpp"

namespace blockweir::safety_text_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A name of words, some longer than any column.
std::string name_of(std::mt19937& random) {
  std::string name = "j" + std::to_string(random() % 1000);
  for (unsigned words = random() % 9; words > 0; --words) name += " on block" + std::to_string(random() % 100);
  return name;
}

json joint(const std::string& name, double size) {
  return {{"name", name},
          {"length_m", 10},
          {"normal_n_per_m", size},
          {"shear_n_per_m", size},
          {"uplift_n_per_m", size},
          {"moment_n", -size},
          {"sliding_factor", 1.2345678},
          {"residual_sliding_factor", nullptr},
          {"resultant_from_downstream", 0.41234},
          {"compressed_length_m", 8},
          {"cracked_length_m", 2},
          {"bonded_length_m", 6.5},
          {"heel_stress_pa", -size},
          {"toe_stress_pa", -size},
          {"downstream_end_m", {10, 0}},
          {"sums", json::array({{{"name", "weight"}, {"x_n_per_m", 0}, {"y_n_per_m", -size}, {"moment_n", size}}})}};
}

json load_case(const std::string& name) {
  return {{"name", name},
          {"class", "usual"},
          {"outcome", "stands"},
          {"level_m", 123.456},
          {"tailwater_m", nullptr},
          {"factor", 1.23456},
          {"limit_analysis_factor", 1.23456},
          {"required", 1.5},
          {"satisfied", false},
          {"set", {"joint.friction_angle_deg=30"}},
          {"scene_warnings", json::array()},
          {"warnings", json::array()},
          {"joints", json::array()}};
}

TEST(SafetyText, AFactorOfLimitAnalysisThatIsMissingHasItsReason) {
  json without = load_case("usual");
  without["limit_analysis_factor"] = nullptr;
  without["why_no_limit_analysis_factor"] = "the simplex method came to no end";
  EXPECT_THAT(blockweir::study::safety_text(json::array({without})),
              HasSubstr("usual: no limit: the simplex method came to no end\n"));
  without["factor"] = nullptr;
  without["why_no_factor"] = without["why_no_limit_analysis_factor"];
  EXPECT_THAT(blockweir::study::safety_text(json::array({without})), Not(HasSubstr("no limit: ")))
      << "the same is said once";
}

TEST(SafetyText, RoundOffIsZero) {
  json strained = load_case("usual");
  strained["joints"].push_back(joint("base", 1e5));
  json& row = strained["joints"][0];
  row["downstream_end_m"] = {17, -1.03e-05};
  row["heel_stress_pa"] = -1e-9;
  row["sums"][0]["x_n_per_m"] = -1e-9;
  const std::string text = blockweir::study::safety_text(json::array({strained}));
  EXPECT_THAT(text, HasSubstr("moments about (17, 0) m"));
  EXPECT_THAT(text, testing::Not(testing::ContainsRegex("-0\\.0* ")));
}

TEST(SafetyText, NamesAreWholeAndRowsFitATerminal) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    json cases = json::array();
    std::vector<std::string> names;
    for (int c = 0; c < 2; ++c) {
      names.push_back(name_of(random));
      cases.push_back(load_case(names.back()));
      for (unsigned joints = random() % 7; joints > 0; --joints) {
        names.push_back(name_of(random));
        cases.back()["joints"].push_back(joint(names.back(), 1 + static_cast<double>(random() % 100'000'000)));
      }
    }
    const std::string text = blockweir::study::safety_text(cases);
    for (const std::string& name : names) EXPECT_THAT(text, HasSubstr(name));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.find_first_not_of("0123456789.- yesNO") == std::string::npos) EXPECT_LE(line.size(), 80U) << line;
    }
  }
}

TEST(SafetyText, ALoadOfWhichNothingIsBorneHasItsLine) {
  json quake = load_case("earthquake");
  quake["water_factor"] = {{"factor", nullptr}};
  quake["load_factor"] = {
      {"factor", nullptr}, {"loads", {"[earthquake]"}}, {"constant", {"weight", "the earthquake's added water"}}};
  const std::string text = blockweir::study::safety_text(json::array({quake}));
  EXPECT_THAT(text, HasSubstr("earthquake: it does not stand even without the water's pressure (limit analysis)\n"));
  EXPECT_THAT(text, HasSubstr("earthquake: it does not stand under weight and the earthquake's added water alone, even "
                              "without the inertia of [earthquake] (limit analysis)\n"));
}

TEST(SafetyText, WhatHoldsForSeveralLoadCasesIsSaidOnce) {
  json usual = load_case("usual");
  usual["mechanism"] = {{"text", "block \"a\" slides"}};
  json flood = usual;
  flood["name"] = "flood";
  flood["tailwater_m"] = 2;
  EXPECT_THAT(blockweir::study::safety_text(json::array({usual, flood})),
              HasSubstr("all load cases: mechanism: block \"a\" slides\nflood: tailwater at 2 m\n"));
  const std::string three = blockweir::study::safety_text(json::array({usual, flood, load_case("dry")}));
  EXPECT_THAT(three, HasSubstr("\n\"usual\", \"flood\": mechanism: block \"a\" slides\nflood: tailwater"));
}

TEST(SafetyText, OfALoadCaseThatFailsNoFactorAboveOneOnItsLoadsIsSaid) {
  json normal = load_case("normal");
  normal["water_factor"] = {{"factor", 1.0553}};
  normal["load_factor"] = {{"factor", 5.38}, {"loads", {"[silt]"}}, {"constant", {"weight"}}};
  EXPECT_THAT(blockweir::study::safety_text(json::array({normal})), HasSubstr("it bears 1.0553 times"));
  normal["outcome"] = "fails";
  EXPECT_THAT(blockweir::study::safety_text(json::array({normal})), testing::Not(HasSubstr("it bears")));
}

TEST(SafetyText, TheFactorOnTheWaterSaysWithWhichForceOfAnchors) {
  json normal = load_case("normal");
  normal["water_factor"] = {{"factor", 1.0211}, {"with_anchors_at_yield", 1.3908}};
  EXPECT_THAT(blockweir::study::safety_text(json::array({normal})),
              HasSubstr("it bears 1.0211 times what the water presses with anchors at their prestress, 1.3908 times "
                        "with anchors at their yield force, by limit analysis"));
  normal["water_factor"]["with_anchors_at_yield"] = nullptr;  // they bear any force
  EXPECT_THAT(blockweir::study::safety_text(json::array({normal})),
              HasSubstr("with anchors at their prestress, by limit analysis"));
}

TEST(SafetyText, JointsOfOneNameHaveTheirElevations) {
  json set = load_case("usual");
  for (const auto& [low_m, high_m] : {std::pair{26.849, 27.058}, {-1e-6, 1e-6}}) {
    set["joints"].push_back(joint("lifts", 1e5));
    set["joints"].back()["upstream_end_m"] = {0, high_m};
    set["joints"].back()["downstream_end_m"] = {4, low_m};
  }
  set["joints"].push_back(joint("base", 1e5));
  const std::string text = blockweir::study::safety_text(json::array({set}));
  for (const char* row : {"\nlifts, 26.85 to 27.06 m\n", "\nlifts, 0 m ", "\nbase  "})
    EXPECT_THAT(text, HasSubstr(row));
}

/// A table that a stranger reads has its symbols explained, and moments are kNm of a metre.
TEST(SafetyText, ALegendSaysOnceWhatTheColumnsAreAndALineWhichJointHasNoRow) {
  json first = load_case("first");
  first["joints"].push_back(joint("base", 1e6));
  json second = first;
  second["name"] = "second";
  second["bent_joints"] = {"wedge plane"};
  const std::string text = blockweir::study::safety_text(json::array({first, second}));
  const auto legend = text.find("M moment of N about");
  EXPECT_NE(legend, std::string::npos) << text;
  EXPECT_EQ(text.find("M moment of N about", legend + 1), std::string::npos);
  for (const char* unit : {"M kNm/m", "moment kNm/m"}) EXPECT_THAT(text, HasSubstr(unit));
  const std::string line = "no row for joint \"wedge plane\", which bends";
  EXPECT_GT(text.find(line), text.find("joints that run through, second")) << text;
  second["joints"] = json::array();
  EXPECT_THAT(blockweir::study::safety_text(json::array({second})), HasSubstr(line));
}

TEST(SafetyText, AnUpperBoundBelowTheRequiredFactorDecidesWithoutTheBlocks) {
  json answer = {{"outcome", "not found"}, {"factor", nullptr}, {"limit_analysis_factor", 0.787}};
  EXPECT_EQ(blockweir::study::satisfied(answer, 1.1), false);
  EXPECT_TRUE(blockweir::study::satisfied(answer, 0.7).is_null());
  EXPECT_TRUE(blockweir::study::satisfied(answer, std::nullopt).is_null());
  answer["limit_analysis_factor"] = nullptr;
  EXPECT_TRUE(blockweir::study::satisfied(answer, 1.1).is_null());
  answer = {{"outcome", "stands"}, {"factor", 1.2}, {"limit_analysis_factor", 1.3}};
  EXPECT_EQ(blockweir::study::satisfied(answer, 1.1), true);
  EXPECT_EQ(blockweir::study::satisfied(answer, 1.25), false);
}

TEST(SafetyText, JointsThatAreOnlyAPartOfASurfaceHaveTheirForcesAndNoFactor) {
  json with = load_case("usual");
  with["joint_parts"] = {{{"name", "seam"},
                          {"length_m", 42.43},
                          {"normal_n_per_m", 12e6},
                          {"shear_n_per_m", 7.5e6},
                          {"uplift_n_per_m", 3.2e6},
                          {"strength_n_per_m", 9.9e6}}};
  const std::string without_rows = blockweir::study::safety_text(json::array({with}));
  EXPECT_THAT(without_rows, HasSubstr("parts of a surface, usual"));
  with["joints"].push_back(joint("base", 1e6));
  const std::string text = blockweir::study::safety_text(json::array({with}));
  EXPECT_THAT(text, HasSubstr("seam                    42.430   12000.0    7500.0    3200.0        9900.0"));
  std::istringstream lines(text.substr(text.find("parts of a surface")));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

}  // namespace
}  // namespace blockweir::safety_text_test
