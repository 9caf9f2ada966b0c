// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Water that comes in at the mesh's ends: on two ranks, at both ends, and down as well as up.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_inflow_test {
namespace {

class Inflow : public OpenFoam {
 protected:
  const std::string coarse = cells(11) + set("coupling.window_s=0.05") + set("analysis.step_s=0.05");

  struct Levels {
    double upstream = std::nan("");
    double downstream = std::nan("");
  };
  /// Beside the structure at the run's end.
  [[nodiscard]] Levels last(const std::string& out) const {
    std::istringstream lines(text(out + "/history.csv"));
    std::string row;
    for (std::string line; std::getline(lines, line);) row = line;
    std::istringstream cells_of_row(row);
    std::string cell;
    std::vector<double> values;
    while (values.size() < 3 && std::getline(cells_of_row, cell, ',')) values.push_back(std::stod(cell));
    return values.size() == 3 ? Levels{values[1], values[2]} : Levels{};
  }
};

TEST_F(Inflow, BringsBothPoolsToTheirLevels) {
  const std::string down =
      set("water.downstream_level_m={table=[[0,10],[1,10],[9,9.5]]}") + set("fluid.downstream_depths=1.8") + coarse;
  EXPECT_EQ(run(cases + "rising-pool", "o", down), 0) << text("out");
  EXPECT_NEAR(last("o").upstream, 11, 0.02);
  EXPECT_NEAR(last("o").downstream, 9.5, 0.01);
}

TEST_F(Inflow, IsTheSameOnTwoRanks) {
  const std::string more = coarse + set("analysis.duration_s=12");
  EXPECT_EQ(run(cases + "rising-pool", "one", more), 0) << text("out");
  EXPECT_EQ(run(cases + "rising-pool", "two", more + set("fluid.processes=2")), 0) << text("out");
  EXPECT_GT(last("one").upstream, 10.5);
  EXPECT_NEAR(last("two").upstream, last("one").upstream, 1e-3);
}

TEST_F(Inflow, CountsTheDepthOfWavesFromTheGround) {
  const std::string more =
      cells(20) + set("coupling.window_s=0.04") + set("analysis.step_s=0.04") + set("analysis.duration_s=12");
  EXPECT_EQ(run(cases + "standing-wave", "on", more), 0) << text("out");
  EXPECT_EQ(run(cases + "standing-wave", "above", more + set("fluid.floor_m=-1")), 0) << text("out");
  const double force = got("on", "force_x_amplitude");
  EXPECT_GT(force, 3000);
  EXPECT_NEAR(got("above", "force_x_amplitude") / force, 1, 0.01);
}

TEST_F(Inflow, SaysWhatWavesItCannotMake) {
  EXPECT_EQ(run(cases + "standing-wave", "o", set("fluid.wave.period_s=20")), 1);
  EXPECT_THAT(text("out"), testing::HasSubstr("has an Ursell number of "));
}

}  // namespace
}  // namespace blockweir::test::openfoam_inflow_test
