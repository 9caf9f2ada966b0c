// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// blockweir report of folders, of results and of what is not there.
#include "tests/coupling/report_page.hpp"

namespace blockweir::test::report_folders_test {
namespace {

using testing::HasSubstr;

TEST_F(Report, OfARunThatIsThereTakesItsResults) {
  write_scene();
  ASSERT_EQ(shell(programs + "/blockweir run wall.toml --quiet --out run"), 0) << text("out");
  ASSERT_EQ(shell(programs + "/blockweir report run"), 0) << text("out");
  EXPECT_THAT(text("run/report.html"), HasSubstr("\"outcome\":\"fails\""));
  EXPECT_EQ(shell(programs + "/blockweir report run --set joint.friction_angle_deg=50"), 2);
  EXPECT_THAT(text("out"), HasSubstr("found a run, beside --set or --variant; expected a scene"));
}

TEST_F(Report, ASummaryThatIsCutOffIsToldFromOneThatIsMissing) {
  write_scene();
  ASSERT_EQ(shell(programs + "/blockweir run wall.toml --out r --quiet"), 0) << text("out");
  fs::resize_file(folder / "r/summary.json", fs::file_size(folder / "r/summary.json") / 2);
  EXPECT_EQ(shell(programs + "/blockweir report r"), 2);
  EXPECT_THAT(text("out"),
              HasSubstr("r: found a summary.json that is cut off or damaged; expected the whole file; make "
                        "the run anew with blockweir run r/scene.toml"));
  fs::remove(folder / "r/summary.json");
  EXPECT_EQ(shell(programs + "/blockweir report r"), 2);
  EXPECT_THAT(text("out"), HasSubstr("r: found a run without a summary.json; expected one that has ended; make it anew "
                                     "with blockweir run r/scene.toml, as it has no checkpoint"));
}

TEST_F(Report, OfResultsThatAreNoRunSaysThatItRunsTheirScene) {
  write_scene();
  ASSERT_EQ(shell(programs + "/blockweir level wall.toml --out l --quiet"), 0) << text("out");
  EXPECT_EQ(shell(programs + "/blockweir report l --run r --out page.html"), 0);
  EXPECT_THAT(text("out"),
              HasSubstr("l: these are results of \"blockweir level\", not of a run: their scene is run first\n"));
  fs::remove(folder / "l/scene.toml");  // as in a folder of reliability
  EXPECT_EQ(shell(programs + "/blockweir report l"), 2);
  EXPECT_THAT(text("out"), HasSubstr("l: found results of \"blockweir level\", without its scene; expected a folder"));
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("is run first")));
}

TEST_F(Report, WritesNothingWhereItCannot) {
  write_scene();
  EXPECT_EQ(shell(programs + "/blockweir report wall.toml --out nowhere/wall.html"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--out"));
  EXPECT_EQ(shell(programs + "/blockweir report wall.toml --set joint.frictoin=3 --out wall.html"), 2);
  EXPECT_THAT(text("out"), HasSubstr("frictoin"));
  EXPECT_EQ(shell(programs + "/blockweir report wall.toml --reliability nowhere --out wall.html"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--reliability nowhere: found no reliability.json"));
  EXPECT_FALSE(fs::exists(folder / "wall.html"));
  EXPECT_FALSE(fs::exists(folder / "runs"));
}

/// A search of a jointed dam takes minutes: it tells how far it is, and Ctrl-C leaves the page with what is known.
TEST_F(Report, AStopOfASearchLeavesThePage) {
  std::ofstream(folder / "jointed.toml") << R"(analysis = { duration_s = 0.05 }
water = { upstream_level_m = 9 }
joint = { friction_angle_deg = 45, uplift = "triangular" }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2200 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-20, -6], [25, -6], [25, 0], [-20, 0]]
[section]
material = "m"
outline_m = [[0, 0], [9, 0], [2, 12], [0, 12]]
[[joint_set]]
name = "courses"
dip_deg = 5
spacing_m = 2
offset_m = 1
friction_angle_deg = 25
uplift = "none"
[[joint_set]]
name = "cross joints"
dip_deg = 90
spacing_m = 1
offset_m = 1.5
friction_angle_deg = 30
uplift = "none"
)";
  ASSERT_EQ(shell(programs + "/blockweir run jointed.toml --quiet --out r"), 0) << text("out");
  const pid_t report = start(programs + "/blockweir report r", "log");
  for (int wait = 0; wait < 60'000 && text("log").find("linear systems solved") == std::string::npos; ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(report, SIGINT);
  EXPECT_EQ(end_of(report, 20), 130);
  EXPECT_THAT(text("log"), testing::AllOf(HasSubstr("level by rigid blocks: "), HasSubstr("report  r/report.html")));
  const nlohmann::json seen = opened("r/report.html");
  ASSERT_TRUE(seen.is_object()) << text("log") << text("browser.log");
  EXPECT_EQ(seen["faults"], nlohmann::json::array());
  EXPECT_THAT(seen["verdict"].get<std::string>(),
              testing::AllOf(HasSubstr("The structure STANDS"), HasSubstr("No answer on factors of safety: not asked"),
                             HasSubstr("No answer on the level of failure: stopped on request; known by then: level by "
                                       "rigid blocks: ")));
}

}  // namespace
}  // namespace blockweir::test::report_folders_test
