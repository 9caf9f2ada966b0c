// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_process
// What a command started and left behind does not outlive the call: mpirun may end before its ranks do. What is said
// of a run that breaks off is its cause, not what we have done about it.
#include "bridge/process/supervisor.hpp"

#include <chrono>

#include "bridge/process/failure_cause.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::supervisor_test {
namespace {

class Supervisor : public Processes {
 protected:
  /// Runs `line` in a shell in this test's folder.
  [[nodiscard]] process::Supervised run(const std::string& line, double grace_s) const {
    return process::supervise({in_shell("sh", line)}, folder, grace_s, [] { return true; });
  }
  /// What is said of two at once, of which the second does as `line` says and the first gives it up with a last word.
  [[nodiscard]] std::string trouble_with(const std::string& line) const {
    const auto first =
        in_shell("solid", "while [ ! -e begun ]; do sleep 0.01; done; echo \"the last word\" >&2; exit 1");
    return process::failure_cause(
        process::supervise({first, in_shell("fluid", line)}, folder, 0.2, [] { return true; }), folder, 7);
  }
  [[nodiscard]] process::Command in_shell(const std::string& name, const std::string& line) const {
    return {name, {"sh", "-c", "cd " + folder.string() + " && " + line}};
  }
};

TEST_F(Supervisor, WhatIsLeftBehindMayEndByItself) {
  EXPECT_TRUE(run("(sleep 0.3; echo done >grandchild) & exit 0", 20).all_fine());
  EXPECT_EQ(text("grandchild"), "done\n");
  EXPECT_FALSE(orphan());
}

TEST_F(Supervisor, WhatIsLeftBehindAndStaysIsKilled) {
  EXPECT_TRUE(run("setsid sleep 250 & exit 0", 0.1).all_fine());
  EXPECT_FALSE(orphan());
}

TEST_F(Supervisor, OneAsideIsWaitedForAndItsFailureIsNobodyElses) {
  process::Command aside = in_shell("aside", "while [ ! -e ended ]; do sleep 0.01; done; echo done >aside; exit 3");
  aside.aside = true;
  const process::Supervised both =
      process::supervise({in_shell("solid", "touch ended"), aside}, folder, 20, [] { return true; });
  EXPECT_TRUE(both.all_fine());
  EXPECT_EQ(both.ends.size(), 1U);
  EXPECT_EQ(text("aside"), "done\n");
}

TEST_F(Supervisor, NotConnectedYetTheOthersAreEndedASecondAfterAFailure) {
  const auto begin = std::chrono::steady_clock::now();
  const process::Supervised both = process::supervise(
      {in_shell("fluid", "exit 1"), in_shell("solid", "exec sleep 250")}, folder, 100, [] { return false; });
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(100));  // the grace of connected ones
  EXPECT_EQ(both.ends.front().name, "fluid");
  EXPECT_TRUE(both.ends.back().by_us);
}

TEST_F(Supervisor, OneAsideIsKilledOnceTheOthersHaveEndedBadly) {
  process::Command aside = in_shell("aside", "exec sleep 250");
  aside.aside = true;
  const auto begin = std::chrono::steady_clock::now();
  const process::Supervised both =
      process::supervise({in_shell("solid", "exit 1"), aside}, folder, 100, [] { return true; });
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(100));  // the grace of the others
  EXPECT_EQ(both.ends.front().exit_code, 1);
  EXPECT_FALSE(orphan());
}

TEST_F(Supervisor, OneThatIsAloneAndStoppedIsWaitedForNoLongerThanTheGrace) {
  process::Command aside = in_shell("aside", "kill -STOP $$; sleep 250");
  aside.aside = true;
  const std::string stops = "trap 'echo left >order; exit 1' TERM; kill -STOP $$; while :; do sleep 0.01; done";
  const process::Supervised alone =
      process::supervise({in_shell("solid", stops), aside}, folder, 0.5, [] { return true; });
  EXPECT_TRUE(alone.ends.front().stopped);
  EXPECT_EQ(text("order"), "left\n");
  const process::Supervised after =
      process::supervise({in_shell("solid", "exit 0"), aside}, folder, 0.5, [] { return true; });
  EXPECT_TRUE(after.all_fine());
  EXPECT_FALSE(orphan());
}

TEST_F(Supervisor, OneThatHangsAndIsKilledIsNotTheCause) {
  EXPECT_EQ(trouble_with("trap '' TERM; touch begun; while :; do :; done"), "the last word");
  EXPECT_FALSE(orphan());
}

TEST_F(Supervisor, OneThatRepeatsWhatTheOtherSaidIsNotTheCause) {
  EXPECT_EQ(trouble_with("touch begun; echo 'fluid: solid process stopped in window 0: the last word' >&2; exit 1"),
            "the last word");
}

TEST_F(Supervisor, OneThatIsStoppedIsTheCauseAndWokenToLeaveInOrder) {
  EXPECT_EQ(
      trouble_with("trap 'echo left >order; exit 1' TERM; touch begun; kill -STOP $$; while :; do sleep 0.01; done"),
      "the fluid process was stopped (SIGSTOP) and answered no more; timeout_s of [coupling], 7 s, sets the patience");
  EXPECT_EQ(text("order"), "left\n");
}

TEST_F(Supervisor, OneThatHasStartedAStoppedProcessIsTheCauseToo) {
  EXPECT_EQ(
      trouble_with("(touch begun; kill -STOP $(exec sh -c 'echo $PPID')); sleep 250"),
      "the fluid process was stopped (SIGSTOP) and answered no more; timeout_s of [coupling], 7 s, sets the patience");
  EXPECT_FALSE(orphan());
}

TEST_F(Supervisor, OneThatHasNoMemoryToStartIsToldAsThat) {
  const std::string said = "error while loading shared libraries: lib.so.0: failed to map segment from shared object";
  EXPECT_THAT(trouble_with("touch begun; echo '" + said + "' >&2; kill -ABRT $$"),
              testing::AllOf(testing::StartsWith("not enough memory for the fluid process to start"),
                             testing::HasSubstr("ulimit -v")));
}

TEST_F(Supervisor, OneThatIsKilledByAnotherIsTheCause) {
  EXPECT_EQ(trouble_with("touch begun; kill -KILL $$"), "the fluid process was ended by signal 9");
}

}  // namespace
}  // namespace blockweir::test::supervisor_test
