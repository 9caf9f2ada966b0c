// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Where the time of a run went: both sides, every fluid, as numbers, as a tree and as a picture.
#include "tests/processes.hpp"

namespace blockweir::test::profile_test {
namespace {

using testing::HasSubstr;
using Profile = Processes;

TEST_F(Profile, IsATreeAndAPictureOfEveryFluidsRun) {
  for (const std::string scene : {"cracked-dam-upper", "u-tube", "column"}) {
    SCOPED_TRACE(scene);
    ASSERT_EQ(shell(programs + "/blockweir run " + cases + scene + " --quiet --out o"), 0) << text("out");
    const auto summary = nlohmann::json::parse(text("o/summary.json"));
    double solid_s = 0;
    for (const auto& [phase, seconds] : summary["profile_s"].items()) {
      EXPECT_GE(seconds.get<double>(), 0) << phase;
      if (phase.rfind("fluid_", 0) != 0) solid_s += seconds.get<double>();
    }
    EXPECT_LE(solid_s, summary["wall_time_s"].get<double>());
    for (const char* phase : {"start_up", "search", "contact", "assembly", "factorization", "solve", "state_changes",
                              "accept", "watch", "output"}) {
      EXPECT_GT(summary["profile_s"].value(phase, 0.0), 0) << phase;
    }
    for (const char* what : {"steps", "undone_steps", "iterations", "state_changes", "multiplier_sweeps",
                             "factorizations", "reused_factorizations", "searches", "exchanges"}) {
      EXPECT_TRUE(summary["counts"].contains(what)) << what;
    }
    EXPECT_GT(summary["peak_memory_mb"]["solid"], 1);
    ASSERT_EQ(shell(programs + "/blockweir profile o"), 0) << text("out");
    EXPECT_THAT(text("out"), testing::AllOf(HasSubstr("contact search"), HasSubstr("MB at most")));
    if (scene != "column") {
      EXPECT_GT(summary["profile_s"]["fluid_wait"], 0);
      EXPECT_GT(summary["peak_memory_mb"]["fluid"], 1);
      EXPECT_THAT(text("out"), HasSubstr("waiting for blocks"));
    }
    EXPECT_GT(fs::file_size(folder / "o/profile.png"), 1000U);
    fs::remove_all(folder / "o");
  }
}

TEST_F(Profile, OfOneProcessCountsItsWaterOnce) {
  ASSERT_EQ(shell(programs + "/blockweir run " + cases + "cracked-dam-upper --inproc --quiet --out o"), 0);
  const auto summary = nlohmann::json::parse(text("o/summary.json"));
  const auto& s = summary["profile_s"];
  const double fluid_s = s["fluid_step"].get<double>() + s["fluid_mapping"].get<double>();
  EXPECT_GE(s["wait_for_fluid"].get<double>(), fluid_s);
}

TEST_F(Profile, AsksForTheFolderOfARun) {
  EXPECT_EQ(shell(programs + "/blockweir profile nowhere"), 2);
  EXPECT_THAT(text("out"), HasSubstr("nowhere: found no summary.json with profile_s"));
}

}  // namespace
}  // namespace blockweir::test::profile_test
