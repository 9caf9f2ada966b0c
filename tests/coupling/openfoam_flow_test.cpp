// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Water that flows through the joints of a dam, its heads from interFoam's water at their mouths.
#include "tests/openfoam.hpp"

namespace blockweir::test {
namespace {

class FlowOpenFoam : public OpenFoam {
 protected:
  /// A parallel crack: its uplift is the triangular law's, under which the dam fails at 4.9056 m above it.
  static std::string scene(const std::string& more) {
    return cases + "cracked-dam-upper" + set("joints.crack.uplift=flow") +
           set("water.upstream_level_m={table=[[0,19.8],[1.5,20.1]]}") + set("analysis.duration_s=1.5") +
           set("analysis.failure_displacement_m=0.01") + set("analysis.stop_at_failure=true") + more;
  }
  [[nodiscard]] double head(const std::string& out) const {
    return nlohmann::json::parse(text(out + "/summary.json"))["failure"]["head_m"].get<double>();
  }
};

TEST_F(FlowOpenFoam, ACrackedDamFailsAtTheLevelThatItDoesInStillWater) {
  ASSERT_EQ(run(scene(set("fluid.model=hydrostatic")), "still", ""), 0) << text("out");
  ASSERT_EQ(run(scene(cells(20)), "moves", ""), 0) << text("out");
  ASSERT_EQ(run(scene(cells(20) + set("fluid.processes=2")), "ranks", ""), 0) << text("out");
  std::printf("head at the failure: still water %.5f m, OpenFOAM %.5f m, on two ranks %.5f m\n", head("still"),
              head("moves"), head("ranks"));
  EXPECT_NEAR(head("still"), 4.9056, 5e-3);
  EXPECT_NEAR(head("moves"), head("still"), 2e-3);
  EXPECT_NEAR(head("ranks"), head("moves"), 1e-4);
  EXPECT_NE(text("moves/openfoam/joint_uplift.csv"), "");
}

}  // namespace
}  // namespace blockweir::test
