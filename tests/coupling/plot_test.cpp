// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// blockweir plot: what is asked for beyond the usual figures.
#include "tests/processes.hpp"

namespace blockweir::test {
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
  EXPECT_EQ(plot("--data nowhere.csv"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--data nowhere.csv: found no such file"));
  std::ofstream(folder / "measured.csv") << "t,block.displacement_x_m\n0,0\n";
  EXPECT_EQ(plot("--data measured.csv"), 2);
  EXPECT_THAT(text("out"), HasSubstr("found \"t\" as the first column; expected time_s"));
}

}  // namespace
}  // namespace blockweir::test
