// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// interFoam's ranks on two nodes of a Slurm allocation, the solid beside them. The nodes are two slurmd of this
// machine: see tests/slurm.sh.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_nodes_test {
namespace {

using testing::HasSubstr;

class OpenFoamOnNodes : public OpenFoam {
 protected:
  void SetUp() override {
    OpenFoam::SetUp();
    if (IsSkipped()) return;
    ASSERT_EQ(shell(script + " up queue 2"), 0) << text("out");
    ::setenv("SLURM_CONF", (folder / "queue/slurm.conf").c_str(), 1);
  }
  void TearDown() override {
    if (IsSkipped()) return;
    EXPECT_EQ(shell(script + " down queue"), 0) << text("out");
    ::unsetenv("SLURM_CONF");
  }
  /// Instead of interFoam: says which rank is on which node, and becomes it.
  void watch_ranks() const {
    fs::create_directory(folder / "bin");
    std::ofstream(folder / "bin/interFoam")
        << "#!/bin/sh\necho \"$OMPI_COMM_WORLD_RANK on $SLURMD_NODENAME\" >>" << (folder / "ranks").string()
        << "\nPATH=${PATH#*:} exec interFoam \"$@\"\n";
    fs::permissions(folder / "bin/interFoam", fs::perms::owner_all);
  }
  const std::string script = std::string(BLOCKWEIR_SOURCE) + "/tests/slurm.sh";
  const std::string wall = cases + "hydrostatic-wall";
  const std::string two = cells(10) + set("analysis.duration_s=0.1") + set("fluid.processes=2");
};

TEST_F(OpenFoamOnNodes, GivesTheSameBitsAsOnOneMachine) {
  ASSERT_EQ(run(wall, "here", two), 0) << text("out");
  watch_ranks();
  std::ofstream(folder / "job.sh") << "#!/bin/sh\nexport PATH=" << (folder / "bin").string() << ":$PATH\n"
                                   << "echo \"solid on $SLURMD_NODENAME\"\n"
                                   << programs << "/blockweir run " << wall << " --quiet --out there" << two << "\n";
  // "sbatch --wait" looks so seldom that it takes longer than the job.
  ASSERT_EQ(shell("sh -c 'job=$(sbatch --parsable --nodes=2 --ntasks-per-node=1 --output=job.log job.sh) && "
                  "while squeue --noheader --jobs=$job | grep -q .; do sleep 0.2; done'"),
            0)
      << text("out") << text("job.log");
  EXPECT_THAT(text("job.log"), HasSubstr("solid on node1"));
  EXPECT_THAT(text("ranks"), testing::AllOf(HasSubstr("0 on node1\n"), HasSubstr("1 on node2\n")));
  EXPECT_EQ(text("there/history.csv"), text("here/history.csv"));
  EXPECT_EQ(text("there/openfoam/water.csv"), text("here/openfoam/water.csv"));
}

TEST_F(OpenFoamOnNodes, OfAnAllocationElsewhereAreRefusedWithWhatToDo) {
  EXPECT_EQ(
      shell("salloc --nodes=2 --ntasks-per-node=1 " + programs + "/blockweir run " + wall + " --quiet --out o" + two),
      1);
  EXPECT_THAT(text("out"), testing::AllOf(HasSubstr("on a machine that is not one of its nodes"), HasSubstr("sbatch")));
}

}  // namespace
}  // namespace blockweir::test::openfoam_nodes_test
