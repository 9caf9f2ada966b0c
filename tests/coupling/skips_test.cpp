// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What is not said between solid and water changes nothing.
#include <cmath>
#include <sstream>

#include "tests/same_results.hpp"

namespace blockweir::test::skips_test {
namespace {

using testing::HasSubstr;

class Skips : public SameResults {
 protected:
  [[nodiscard]] static std::string run_of(const std::string& more) {
    return programs + "/blockweir run " + cases + "cracked-dam-upper " + more;
  }
  /// Runs the scene as it is and with the skip off; the results must be the same, the count of what was skipped not.
  /// Returns the summary, which has a line on each skip.
  [[nodiscard]] std::string line_of_same(const std::string& off, const std::string& more, const char* count) {
    EXPECT_EQ(shell(run_of(more) + " --quiet --out all --set " + off), 0) << text("out");
    EXPECT_EQ(shell(run_of(more) + " --quiet --out few"), 0) << text("out");
    for (const char* file : {"/history.csv", "/frames.jsonl", "/blocks.pvd"}) {
      EXPECT_EQ(text(std::string("all") + file), text(std::string("few") + file)) << file;
    }
    EXPECT_EQ(nlohmann::json::parse(text("all/summary.json"))["counts"][count], 0);
    EXPECT_GT(nlohmann::json::parse(text("few/summary.json"))["counts"][count], 50);
    return text("few/summary.json");
  }
  /// Runs the scene with every exchange made and with those left out that say nothing new; returns how many those are.
  long skipped(const std::string& more) {
    SCOPED_TRACE(more);
    const std::string run = programs + "/blockweir run " + cases + "cracked-dam-upper --quiet " + more;
    EXPECT_EQ(shell(run + " --out all --set coupling.skip_exchanges=false"), 0) << text("out");
    EXPECT_EQ(shell(run + " --out few"), 0) << text("out");
    for (const char* file : {"/history.csv", "/frames.jsonl", "/blocks.pvd"}) {
      EXPECT_EQ(text(std::string("all") + file), text(std::string("few") + file)) << file;
    }
    const auto all = nlohmann::json::parse(text("all/summary.json"))["counts"];
    const auto few = nlohmann::json::parse(text("few/summary.json"))["counts"];
    EXPECT_EQ(all["skipped_exchanges"], 0);
    EXPECT_EQ(few["exchanges"].get<long>() + few["skipped_exchanges"].get<long>(), all["exchanges"].get<long>());
    EXPECT_EQ(few["fluid_updates"], all["fluid_updates"]);
    fs::remove_all(folder / "all");
    fs::remove_all(folder / "few");
    return few["skipped_exchanges"];
  }
};

TEST_F(Skips, NothingIsSaidWhileBlocksAndWaterStand) {
  const std::string steps =
      " --set 'water.upstream_level_m={steps=[[0,20],[1.5,21],[2.5,21.2]]}' --set analysis.duration_s=3";
  EXPECT_GT(skipped(steps), 50);
  EXPECT_GT(skipped(steps + " --set coupling.schedule=parallel"), 50);
  EXPECT_GT(skipped(steps + " --set coupling.schedule=improved"), 50);
  EXPECT_GT(skipped(steps + " --set analysis.step_s=0.01 --set coupling.load_in_window=quadratic"), 50);
}

TEST_F(Skips, WaterThatRisesIsAskedEveryTime) {
  EXPECT_EQ(skipped(" --set analysis.duration_s=3.5"), 0);
}

const std::string in_steps =
    " --set 'water.upstream_level_m={steps=[[0,20],[1.5,21],[2.5,21.2]]}' --set analysis.duration_s=3";

TEST_F(Skips, StillWaterKeepsItsPressuresWhileNothingMoves) {
  const std::string all_said = in_steps + " --set coupling.skip_exchanges=false";
  EXPECT_THAT(line_of_same("water.skip_unchanged=false", all_said, "fluid_unchanged"),
              HasSubstr(" windows: neither a level nor a block had moved, saved about "));
  const auto meshes = [&](const char* more) {
    fs::remove_all(folder / "o");
    EXPECT_EQ(shell(run_of(all_said) + " --quiet --set output.reservoir=true --out o" + more), 0) << text("out");
    return nlohmann::json::parse(text("o/summary.json"))["counts"]["fluid_meshes"].get<long>();
  };
  const long few = meshes("");
  EXPECT_THAT(text("o/summary.json"), HasSubstr(" meshes of the reservoir: neither a level nor a block had moved"));
  EXPECT_LT(few, meshes(" --set water.skip_unchanged=false"));
}

/// Sums of other terms: the same but for round-off, which the solid's tolerances may carry on.
TEST_F(Skips, OnePressureElementOfAFaceDoesAsMuchAsTwenty) {
  ASSERT_EQ(shell(run_of(in_steps) + " --quiet --out few"), 0) << text("out");
  EXPECT_THAT(text("few/summary.json"), HasSubstr("all but one pressure element of a face"));
  ASSERT_EQ(shell(run_of(in_steps) + " --quiet --out all --set water.elements_per_face=20"), 0) << text("out");
  EXPECT_THAT(text("all/summary.json"), testing::Not(HasSubstr("pressure element")));
  std::istringstream few(text("few/history.csv"));
  std::istringstream all(text("all/history.csv"));
  std::string a;
  std::string b;
  for (int row = 0; std::getline(few, a) && std::getline(all, b); ++row) {
    if (row == 0) {
      EXPECT_EQ(a, b);
      continue;
    }
    std::istringstream values(a);
    std::istringstream others(b);
    while (std::getline(values, a, ',') && std::getline(others, b, ',')) {
      if (a == b) continue;
      const double x = std::stod(a);
      EXPECT_NEAR(x, std::stod(b), std::abs(x) < 1 ? 1e-9 : 1e-6 * std::abs(x)) << "row " << row;
    }
  }
  EXPECT_FALSE(std::getline(all, b));
}

TEST_F(Skips, SearchesChangeNoBitOfARun) {
  EXPECT_THAT(line_of_same("analysis.skip_searches=false", in_steps, "skipped_searches"),
              HasSubstr(" searches for contacts: nothing had moved, saved about "));
}

TEST_F(Skips, WhatIsNotDrawnChangesNoRow) {
  ASSERT_EQ(shell(run_of(in_steps) + " --quiet --out few"), 0) << text("out");
  for (const char* drawn : {"output.frame_every_s=0.01", "output.reservoir=true"}) {
    fs::remove_all(folder / "all");
    ASSERT_EQ(shell(run_of(in_steps) + " --quiet --out all --set " + drawn), 0) << text("out");
    EXPECT_EQ(text("few/history.csv"), text("all/history.csv")) << drawn;
  }
}

TEST_F(Skips, ADrySceneStartsNoFluid) {
  ASSERT_EQ(shell(programs + "/blockweir run " + cases + "incline --quiet --out o"), 0) << text("out");
  EXPECT_THAT(text("o/summary.json"), HasSubstr("a fluid process: the scene has no water, saved about "));
  EXPECT_FALSE(fs::exists(folder / "o/hydrostatic.log"));
}

TEST_F(Skips, WhatSleepSavesIsReckonedByStepsOfTheRunNotByThoseThatSettle) {
  ASSERT_EQ(shell(programs + "/blockweir run " + cases + "column --quiet --out o"), 0) << text("out");
  EXPECT_THAT(text("o/summary.json"), HasSubstr("49 of 50 solutions of islands that slept, saved about "));
}

TEST_F(Skips, EachHasItsLineInTheProfile) {
  ASSERT_EQ(shell(run_of(in_steps) + " --quiet --inproc --out o --set block.top.rigid=true"), 0) << text("out");
  const auto all_there =
      testing::AllOf(HasSubstr("skipped strains of 1 block: the scene calls them rigid, saved about "),
                     HasSubstr(" exchanges: no block had moved and the water stood, saved about "),
                     HasSubstr(" solutions of islands that slept, saved about "),
                     HasSubstr(" searches for contacts: nothing had moved, saved about "),
                     HasSubstr("skipped frames after "), HasSubstr(" s is asked for, saved about "),
                     HasSubstr("skipped a second process: the water was within the solid's, saved about "),
                     HasSubstr("skipped the reservoir's mesh: its pictures are not asked for"));
  EXPECT_THAT(text("out"),
              HasSubstr(" kinds of work that the result does not need; \"blockweir profile o\" lists them"));
  ASSERT_EQ(shell(programs + "/blockweir profile o"), 0) << text("out");
  EXPECT_THAT(text("out"), all_there);
}

}  // namespace
}  // namespace blockweir::test::skips_test
