// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Runs with interFoam that were stopped or killed go on, and end as one that was not, to within its solver's tolerance.
#include "tests/openfoam.hpp"

namespace blockweir::test {
namespace {

class ResumeOpenFoam : public OpenFoam {
 protected:
  static std::string scene(const std::string& more) {
    return cases + "cracked-dam-upper" + cells(10) + set("water.upstream_level_m={table=[[0,21.9],[1,22.4]]}") +
           set("analysis.duration_s=1") + set("analysis.stop_at_failure=true") + more;
  }
  [[nodiscard]] pid_t launch(const std::string& out, const std::string& more) const {
    return start(programs + "/blockweir run " + scene(more) + " --quiet --out " + out, "log");
  }
  void expect_same_end(const std::string& out) {
    ASSERT_EQ(shell(programs + "/blockweir resume " + out + " --quiet"), 0) << text("out");
    const auto head = [&](const std::string& run) {
      return nlohmann::json::parse(text(run + "/summary.json"))["failure"]["head_m"].get<double>();
    };
    EXPECT_NEAR(head(out), head("whole"), 1e-6);
    for (const double y : {7.5, 18.5}) {
      const Force a = water_force("whole", {4, y}, 9);
      const Force b = water_force(out, {4, y}, 9);
      EXPECT_LT((b.force - a.force).norm() / a.force.norm(), 1e-3) << y;
      EXPECT_NEAR(b.moment / a.moment, 1, 1e-3) << y;
    }
    const auto rows = [&](const std::string& file) {
      const std::string all = text(file);
      return std::count(all.begin(), all.end(), '\n');
    };
    EXPECT_EQ(rows("whole/openfoam/water.csv"), rows(out + "/openfoam/water.csv"));
  }
};

TEST_F(ResumeOpenFoam, AStoppedRunEndsAsAWholeOne) {
  ASSERT_EQ(end_of(launch("whole", ""), 60), 0) << text("log");
  const pid_t run = launch("stopped", "");
  ASSERT_TRUE(under_way("stopped"));
  kill(run, SIGINT);
  ASSERT_EQ(end_of(run, 20), 130) << text("log");
  EXPECT_THAT(text("log"), testing::HasSubstr("\"blockweir resume stopped\" goes on"));
  expect_same_end("stopped");
}

TEST_F(ResumeOpenFoam, TwoKilledRanksGoOnFromTheLastCheckpoint) {
  const std::string more = set("fluid.processes=2") + set("output.checkpoint_every_s=0.02");
  ASSERT_EQ(end_of(launch("whole", more), 60), 0) << text("log");
  const pid_t run = launch("ranks-killed", more);
  ASSERT_TRUE(under_way("ranks-killed"));
  EXPECT_EQ(shell("pkill -KILL -f '[i]nterFoam.*ranks-killed'"), 0);
  EXPECT_EQ(end_of(run, 30), 1) << text("log");
  expect_same_end("ranks-killed");
}

}  // namespace
}  // namespace blockweir::test
