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

}  // namespace
}  // namespace blockweir::test::report_folders_test
