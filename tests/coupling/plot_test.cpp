// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// blockweir plot: what is asked for beyond the usual figures.
#include "tests/processes.hpp"

namespace blockweir::test::plot_test {
namespace {

using testing::HasSubstr;

class Plot : public Processes {
 protected:
  [[nodiscard]] int plot(const std::string& options) const { return shell(programs + "/blockweir plot o " + options); }
};

TEST_F(Plot, DrawsTheSectionAndMeasuredPoints) {
  ASSERT_EQ(shell(programs + "/blockweir run " + cases + "incline --quiet --out o"), 0) << text("out");
  std::ofstream(folder / "measured.csv") << "time_s,block.displacement_x_m\n0,0\n0.5,0.2\n";
  ASSERT_EQ(plot("--section --blocks block --data measured.csv"), 0) << text("out");
  EXPECT_GT(fs::file_size(folder / "o/section.png"), 1000U);
  EXPECT_GT(fs::file_size(folder / "o/displacements.png"), 1000U);

  EXPECT_EQ(plot("--blocks blok"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--blocks: found \"blok\", which the run does not have"));
  EXPECT_THAT(text("out"), HasSubstr("did you mean \"block\"?"));
  std::ofstream(folder / "slip.csv") << "time_s,block.displacement_x_m\n0,abc\n";
  fs::remove(folder / "o/displacements.png");
  EXPECT_EQ(plot("--data slip.csv"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--data slip.csv:2: found \"abc\""));
  EXPECT_FALSE(fs::exists(folder / "o/displacements.png"));
  EXPECT_EQ(plot("--data nowhere.csv"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--data nowhere.csv: found no such file"));
  std::ofstream(folder / "measured.csv") << "t,block.displacement_x_m\n0,0\n";
  EXPECT_EQ(plot("--data measured.csv"), 2);
  EXPECT_THAT(text("out"), HasSubstr("found \"t\" as the first column; expected time_s"));
}

TEST_F(Plot, AnAnimationTellsHowFarItIs) {
  ASSERT_EQ(shell(programs + "/blockweir run " + cases + "incline --quiet --out o"), 0) << text("out");
  ASSERT_EQ(plot("--animate"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("100 %  drawing"));
  ASSERT_EQ(plot(""), 0) << text("out");
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("drawing"))) << "that takes a moment";
}

TEST_F(Plot, AStopIsToldAndChangesNoPicture) {
  ASSERT_EQ(shell(programs + "/blockweir run " + cases + "incline --quiet --out o"), 0) << text("out");
  ASSERT_EQ(plot("--animate"), 0) << text("out");
  const auto drawn = fs::last_write_time(folder / "o/animation.gif");
  const auto files = std::distance(fs::directory_iterator(folder / "o"), {});
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\necho drawn >drawing\nexec sleep 60\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  const pid_t plot =
      start("env PATH=" + folder.string() + ":$PATH " + programs + "/blockweir plot --animate o", "said");
  for (int wait = 0; wait < 10'000 && !fs::exists(folder / "drawing"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(plot, SIGINT);
  EXPECT_EQ(end_of(plot, 10), 130);
  EXPECT_EQ(text("said"),
            "blockweir: stopped on request while it drew o; no picture was changed; the same command draws them "
            "anew\n");
  EXPECT_EQ(fs::last_write_time(folder / "o/animation.gif"), drawn);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "o"), {}), files);
}

TEST_F(Plot, TheSectionNamesAnchorsAndLoadsOfEveryKindWithTheirSizes) {
  std::ofstream(folder / "s.toml") << text(cases + "monolith-slides/scene.toml") << R"(
[[bolt]]
name = "anchor"
from_block = "monolith"
from_m = [0.5, 8]
to_m = [1, -2]
stiffness_n_per_m2 = 1e6
prestress_n_per_m = 5e3
[ice]
thrust_n_per_m = 20e3
thickness_m = 0.4
[earthquake]
horizontal_coefficient = 0.05
)";
  ASSERT_EQ(shell(programs + "/blockweir run s.toml --quiet --out o --set water.upstream_level_m=5"), 0) << text("out");
  ASSERT_EQ(plot("--section --svg"), 0) << text("out");
  const std::string drawn = text("o/section.svg");
  for (const char* label : {"anchor ", "ice 20 kN/m", "added water (Westergaard) ", "water upstream 122.6 kN/m",
                            "face pressure 52.5 kN/m"}) {
    EXPECT_THAT(drawn, HasSubstr(label));
  }
}

}  // namespace
}  // namespace blockweir::test::plot_test
