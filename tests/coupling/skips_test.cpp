// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What is not said between solid and water changes nothing.
#include "tests/same_results.hpp"

namespace blockweir::test {
namespace {

class Skips : public SameResults {
 protected:
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
  EXPECT_GT(skipped(steps + " --set coupling.load_in_window=quadratic"), 50);
}

TEST_F(Skips, WaterThatRisesIsAskedEveryTime) {
  EXPECT_EQ(skipped(" --set analysis.duration_s=3.5"), 0);
}

}  // namespace
}  // namespace blockweir::test
