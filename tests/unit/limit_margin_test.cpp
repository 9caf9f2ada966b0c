// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_process
// What a run's summary takes from limit analysis beside it.
#include "bridge/process/limit_margin.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace blockweir::process::limit_margin_test {
namespace {

using nlohmann::json;

/// The summary of a run with this outcome beside limit analysis with this factor.
json told(const std::string& outcome, const json& factor, bool last_levels_acted = true, bool any_forces = false) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "limit_margin";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "margin.json") << json{{"factor", factor},
                                                {"level_m", nullptr},
                                                {"mechanism", {{"text", "block \"a\" slides"}}},
                                                {"stands_by_any_forces", any_forces}};
  json summary = {{"outcome", outcome}, {"warnings", json::array()}};
  if (!last_levels_acted) summary["last_levels_acted"] = false;
  LimitMargin(folder).add_to(summary);
  std::filesystem::remove_all(folder);
  return summary;
}

TEST(LimitMargin, WhatStandsAboveAnUpperBoundIsWarnedOf) {
  const json summary = told("stands", 0.93);
  EXPECT_EQ(summary["limit_analysis"]["factor"], 0.93);
  ASSERT_EQ(summary["warnings"].size(), 1U);
  EXPECT_THAT(summary["warnings"][0].get<std::string>(),
              testing::HasSubstr("it stands although limit analysis, an upper bound, has a factor of 0.93"));
}

/// A run whose last window had a lower level has moved nowhere, and no corner holds it.
TEST(LimitMargin, OfALevelThatTheBlocksHaveNotFeltNoOtherCauseIsSaid) {
  const json warnings = told("stands", 0.8268, /*last_levels_acted=*/false)["warnings"];
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].get<std::string>(),
            "it stands under the levels of the last window: under the last ones of the scene the factor by limit "
            "analysis, an upper bound, is 0.8268");
  EXPECT_THAT(told("stands", 1.2, false)["warnings"], testing::IsEmpty());
}

TEST(LimitMargin, OtherwiseTheFactorIsToldAlone) {
  for (const auto& [outcome, factor] : {std::pair{"stands", 0.9995}, {"stands", 1.5}, {"fails", 0.93}}) {
    EXPECT_THAT(told(outcome, factor)["warnings"], testing::IsEmpty()) << outcome << factor;
  }
}

/// A level that rises and falls again ends below the one that brought the structure down.
TEST(LimitMargin, AFactorAbove1OfAFailureHasItsReason) {
  const auto text = [](const json& last_level_m) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "limit_margin_above_1";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "margin.json")
        << json{{"factor", 5.088}, {"level_m", last_level_m}, {"mechanism", {{"text", "block \"a\" slides"}}}};
    json summary = {{"outcome", "fails"}, {"warnings", json::array()}, {"failure", {{"level_m", 4.1525}}}};
    LimitMargin(folder).add_to(summary);
    std::filesystem::remove_all(folder);
    return summary["limit_analysis"]["text"].get<std::string>();
  };
  EXPECT_THAT(text(2), testing::HasSubstr("at a level of 2 m: block \"a\" slides; above 1, as that is the scene's last "
                                          "level: it failed at 4.152 m"));
  EXPECT_THAT(text(4.2), testing::HasSubstr("above 1 although it fails, as an upper bound may be"));
  EXPECT_THAT(text(nullptr), testing::HasSubstr("above 1 although it fails, as an upper bound may be"));
}

TEST(LimitMargin, ManyRigidBlocksThatStandPointToSafety) {
  const auto text = [](const char* outcome, bool any_forces) {
    return told(outcome, 1.5, true, any_forces)["limit_analysis"]["text"].get<std::string>();
  };
  const auto points = testing::HasSubstr("strain may find others: \"blockweir safety\" asks");
  EXPECT_THAT(text("stands", true), points);
  EXPECT_THAT(text("stands", false), testing::Not(points));
  EXPECT_THAT(text("fails", true), testing::Not(points));
}

}  // namespace
}  // namespace blockweir::process::limit_margin_test
