// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Water that flows through the joints of a dam, its heads from interFoam's water at their mouths.
#include "bridge/results/csv.hpp"
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_flow_test {
namespace {

class FlowOpenFoam : public OpenFoam {
 protected:
  /// A parallel crack: its uplift is the triangular law's, under which the dam fails at 4.9056 m above it.
  void write_scene() const {
    std::ifstream file(cases + "cracked-dam-upper/scene.toml");
    std::ostringstream all;
    all << file.rdbuf();
    std::ofstream(folder / "scene.toml") << all.str().substr(0, all.str().find("[[expect]]"));
  }
  [[nodiscard]] int run_dam(const std::string& out, const std::string& duration_s, const std::string& more) const {
    return run("scene.toml", out,
               set("joints.crack.uplift=flow") + set("water.upstream_level_m={table=[[0,19.8],[1.5,20.1]]}") +
                   set("analysis.duration_s=" + duration_s) + set("analysis.failure_displacement_m=0.01") +
                   set("analysis.stop_at_failure=true") + more);
  }
  [[nodiscard]] double head(const std::string& out) const {
    return nlohmann::json::parse(text(out + "/summary.json"))["failure"]["head_m"].get<double>();
  }
  /// Of the crack after 0.1 s [N/m].
  [[nodiscard]] double uplift(const std::string& out) const {
    std::istringstream lines(text(out + "/openfoam/joint_uplift.csv"));
    for (std::string line; std::getline(lines, line);) {
      const std::vector<std::string> cells = results::csv_cells(line);
      if (cells[0] == "0.1") return std::stod(cells[5]);
    }
    return std::nan("");
  }
};

TEST_F(FlowOpenFoam, ACrackedDamFailsAtTheLevelThatItDoesInStillWater) {
  write_scene();
  ASSERT_EQ(run_dam("still", "1.5", set("fluid.model=hydrostatic")), 0) << text("out");
  ASSERT_EQ(run_dam("moves", "1.5", cells(20)), 0) << text("out");
  std::printf("head at the failure: still water %.5f m, OpenFOAM %.5f m\n", head("still"), head("moves"));
  EXPECT_NEAR(head("still"), 4.9056, 5e-3);
  EXPECT_NEAR(head("moves"), head("still"), 2e-3);
}

TEST_F(FlowOpenFoam, TwoRanksHaveTheUpliftOfOne) {
  write_scene();
  ASSERT_EQ(run_dam("one", "0.12", cells(20)), 0) << text("out");
  ASSERT_EQ(run_dam("two", "0.12", cells(20) + set("fluid.processes=2")), 0) << text("out");
  EXPECT_NEAR(uplift("two") / uplift("one"), 1, 1e-5);
}

/// What is missing ends interFoam when it is first called, be it by the rarest warning.
TEST_F(FlowOpenFoam, ThePluginHasAllOfOursThatItCalls) {
  const std::string plugin = programs + "/libblockweirOpenFOAM.so";
  ASSERT_EQ(shell("nm --dynamic --demangle --undefined-only " + plugin), 0);
  EXPECT_EQ(text("out").find("blockweir::"), std::string::npos) << text("out");
}

}  // namespace
}  // namespace blockweir::test::openfoam_flow_test
