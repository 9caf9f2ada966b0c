// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What blocks in the water cost: interFoam with the plugin and the solid against interFoam alone, on the same mesh with
// the same steps and iterations, and one schedule against the other. Everything is measured in one run.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_overhead_test {
namespace {

struct Cost {
  double wall_s = 0;   ///< from interFoam's start to its end
  double foam_s = 0;   ///< interFoam's own time
  double solid_s = 0;  ///< the solid's, without waiting
  int steps = 0;
  int iterations = 0;  ///< of their pressure solutions
};

class Overhead : public OpenFoam {
 protected:
  static constexpr double duration_s = 1;
  static constexpr double window_s = 0.01;

  void sh(const std::string& command) const {
    EXPECT_EQ(shell("env " + std::string(environment) + "sh -c \"" + command + "\""), 0) << text("out");
  }

  /// A dam in water of one level that moves at 0.1 m/s at first.
  [[nodiscard]] static std::string dam(int cells_in_depth, const std::string& more) {
    return cases + "cracked-dam-upper" + cells(cells_in_depth) + set("fluid.max_courant=1") +
           set("analysis.duration_s=" + std::to_string(duration_s)) + set("water.upstream_level_m=21.7") +
           set("water.downstream_level_m=21.7") + set("output.checkpoint_every_s=0") + set("expect=[]") + more;
  }

  [[nodiscard]] Cost timed(const std::string& folder_name) const {
    const auto start = std::chrono::steady_clock::now();
    sh("interFoam -case " + folder_name + " > log." + folder_name);
    Cost cost;
    cost.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    cost.foam_s = execution_s("log." + folder_name);
    std::istringstream lines(text("log." + folder_name));
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("Time = ", 0) == 0) ++cost.steps;
      const std::size_t at = line.find("No Iterations ");
      if (line.find("for p_rgh") != std::string::npos) cost.iterations += std::stoi(line.substr(at + 14));
    }
    return cost;
  }

  [[nodiscard]] Cost with_blocks(const std::string& scene) const {
    const std::string endpoint = " --endpoint ipc://" + (folder / "line").string();
    fs::remove_all(folder / "with");
    EXPECT_EQ(shell(programs + "/blockweir-openfoam " + scene + " --case-only --out with" + endpoint), 0);
    sh("sed -i 's/^internalField.*/internalField uniform (0.1 0 0);/' with/0/U && "
       "sed -i 's/maxIter 50/minIter 3; maxIter 3/' with/system/fvSolution && blockMesh -case with");
    const pid_t solid = start(programs + "/blockweir-solid " + scene + " --out o" + endpoint, "solid");
    Cost cost = timed("with");
    EXPECT_EQ(end_of(solid, 5), 0) << text("solid");
    const auto profile = nlohmann::json::parse(text("o/summary.json"))["profile_s"];
    for (const char* phase : {"search", "islands", "contact", "assembly", "factorization", "solve", "state_changes",
                              "accept", "rest_of_step", "watch", "output"}) {
      cost.solid_s += profile[phase].get<double>();
    }
    return cost;
  }

  /// The case that with_blocks() has left, without them.
  [[nodiscard]] Cost alone() const {
    fs::remove_all(folder / "without");
    sh("cp -r with without && rm without/system/fvOptions && rm -rf without/[1-9]* without/0.[0-9]* && "
       "sed -i 's/^endTime .*/endTime " +
       std::to_string(duration_s - window_s) + ";/; s/^libs .*//; /^functions/,\\$ d' without/system/controlDict");
    return timed("without");
  }

  void compare(int cells_in_depth, const std::string& solid, const char* what) const {
    const Cost serial = with_blocks(dam(cells_in_depth, solid));
    const Cost foam = alone();
    const Cost parallel = with_blocks(dam(cells_in_depth, solid + set("coupling.schedule=parallel")));
    EXPECT_EQ(serial.steps, foam.steps);
    EXPECT_EQ(serial.iterations, foam.iterations);
    std::printf("%d cells in depth, %d steps, %s: interFoam alone %.2f s (%.2f s of its own time), the solid %.2f s\n",
                cells_in_depth, foam.steps, what, foam.wall_s, foam.foam_s, serial.solid_s);
    std::printf("  serial   %.2f s, %.3f of interFoam alone; its own time %.3f of that alone\n", serial.wall_s,
                serial.wall_s / foam.wall_s, serial.foam_s / foam.foam_s);
    std::printf("  parallel %.2f s, %.3f of the slower side; interFoam's own time %.2f s in %d steps\n",
                parallel.wall_s, parallel.wall_s / std::max(foam.wall_s, parallel.solid_s), parallel.foam_s,
                parallel.steps);
    EXPECT_LT(serial.foam_s, 2 * foam.foam_s);
  }
};

TEST_F(Overhead, OfTheBlocksIsSmall) {
  compare(40, "", "two blocks");
}
TEST_F(Overhead, OfTheBlocksOnAFineMesh) {
  compare(80, "", "two blocks");
}
/// A solid as slow as the water: both sides at once, or in turn.
TEST_F(Overhead, OfTheSchedules) {
  compare(40, set("block.base.mesh_size_m=2") + set("block.top.mesh_size_m=2"), "two blocks with meshes");
}

}  // namespace
}  // namespace blockweir::test::openfoam_overhead_test
