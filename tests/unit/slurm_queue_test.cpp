// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_engine
// Questions to a queue whose commands are stand-ins of these tests: what counts as an answer, and what ends a question.
#include "bridge/engine/slurm_queue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "tests/own_folder.hpp"

namespace blockweir::engine::slurm_queue_test {
namespace {

class SlurmQueue : public test::OwnFolder {
 protected:
  void SetUp() override { ::setenv("PATH", (folder.string() + ":" + before_).c_str(), 1); }
  void TearDown() override { ::setenv("PATH", before_.c_str(), 1); }
  /// A command of the queue that does this in place of its own work.
  void stand_in(const std::string& name, const std::string& does) const {
    const auto file = folder / name;
    std::ofstream(file) << "#!/bin/sh\n" << does << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }

 private:
  std::string before_ = std::getenv("PATH");
};

TEST_F(SlurmQueue, AQuestionThatASignalEndsIsNoAnswer) {
  for (const char* signal : {"INT", "TERM", "KILL"}) {
    stand_in("squeue", std::string("kill -") + signal + " $$");
    const QueueState state = state_of("7");
    EXPECT_FALSE(state.over()) << signal;
    EXPECT_THAT(state.trouble, testing::HasSubstr("squeue ended with status")) << signal;
  }
  stand_in("squeue", "exit 1");
  EXPECT_FALSE(state_of("7").over()) << "it said nothing";
}

TEST_F(SlurmQueue, CommandsAreInAGroupOfTheirOwnWhichATerminalDoesNotReach) {
  stand_in("sbatch", "cut -d' ' -f5 /proc/self/stat");  // the group's number for the job's
  EXPECT_NE(submit("task.sh", "name", 1, folder, {}), std::to_string(::getpgrp()));
}

TEST_F(SlurmQueue, AJobThatIsOverOrUnknownHasLeftIt) {
  stand_in("squeue", "exit 0");
  EXPECT_TRUE(state_of("7").over());
  stand_in("squeue", "echo 'slurm_load_jobs error: Invalid job id specified'; exit 1");
  EXPECT_TRUE(state_of("7").over());
  stand_in("squeue", "echo RUNNING None; echo 'PENDING Priority'");
  const QueueState state = state_of("7");
  EXPECT_EQ(state.running, 1U);
  EXPECT_EQ(state.waiting, 1U);
  EXPECT_EQ(state.reason, "Priority");
}

TEST_F(SlurmQueue, AJobThatCannotBeTakenOutIsTold) {
  stand_in("scancel", "echo 'scancel: error: Unable to contact slurm controller' >&2; exit 1");
  EXPECT_THAT(cancel("7"), testing::HasSubstr("Unable to contact slurm controller"));
  stand_in("scancel", "exit 0");
  EXPECT_EQ(cancel("7"), "");
}

}  // namespace
}  // namespace blockweir::engine::slurm_queue_test
