// SPDX-License-Identifier: GPL-3.0-or-later
// The same scene gives the same bits: in every run, and whatever number of threads the libraries below may use.
#include "tests/processes.hpp"

namespace blockweir::determinism_test {
namespace {

using blockweir::test::cases;
using blockweir::test::programs;

class Determinism : public blockweir::test::Processes {
 protected:
  /// All that a run writes of its motion, as bytes.
  [[nodiscard]] std::string bits(const std::string& scene, const std::string& threads) const {
    const std::string variables = " OMP_NUM_THREADS=" + threads + " OPENBLAS_NUM_THREADS=" + threads;
    const std::string run = "env" + variables + " " + programs + "/blockweir run " + cases + scene + " --quiet --out r";
    EXPECT_EQ(shell(run), 0) << text("out");
    std::string all = text("r/history.csv") + text("r/frames.jsonl");
    blockweir::test::fs::remove_all(folder / "r");
    return all;
  }
};

TEST_F(Determinism, AScenesBitsAreTheSameInEveryRunAndForAnyNumberOfThreads) {
  // Two processes with sliding blocks; then a section of many blocks, solved by sparse factorizations.
  for (const std::string scene :
       {"cracked-dam-lower --set analysis.duration_s=4", "jointed-section --set analysis.duration_s=3"}) {
    const std::string once = bits(scene, "1");
    EXPECT_GT(once.size(), 10000U);
    EXPECT_TRUE(once == bits(scene, "1")) << scene;
    for (const std::string threads : {"2", "7"})
      EXPECT_TRUE(once == bits(scene, threads)) << scene << ", threads " << threads;
  }
}

}  // namespace
}  // namespace blockweir::determinism_test
