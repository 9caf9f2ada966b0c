// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_results nlohmann_json::nlohmann_json
// A folder that a run writes to is no other run's; a run that has ended has nothing to resume.
#include <fmt/format.h>

#include "bridge/results/folder_lock.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::folder_in_use_test {
namespace {

using testing::HasSubstr;

class FolderInUse : public Processes {
 protected:
  const std::string long_run =
      programs + "/blockweir run " + cases + "cracked-dam-upper --set analysis.step_s=0.001 --out o";
};

TEST_F(FolderInUse, ASecondRunIsRefusedWithTheNumberOfTheFirst) {
  const pid_t first = start(long_run + " --quiet", "first");
  ASSERT_TRUE(under_way("o"));
  const std::string refusal =
      fmt::format("o: another run writes there, that of process {}; choose another --out", first);
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr(refusal));
  EXPECT_EQ(shell(programs + "/blockweir resume o"), 2);
  EXPECT_THAT(text("out"), HasSubstr(refusal));
  EXPECT_EQ(shell(programs + "/blockweir-solid " + cases + "incline --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr(refusal));
  kill(first, SIGINT);
  EXPECT_EQ(end_of(first, 20), 130) << text("first");
}

TEST_F(FolderInUse, AKilledRunLetsGoOfItOnceItsProcessesHaveEnded) {
  const pid_t first = start(long_run + " --quiet", "first");
  ASSERT_TRUE(under_way("o"));
  kill(first, SIGKILL);
  EXPECT_EQ(end_of(first, 5), 128 + SIGKILL);
  for (int wait = 0; wait < 400 && orphan(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_TRUE(fs::exists(folder / "o" / results::FolderLock::file));
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --quiet --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("o: found a run of another scene"));  // it is free, and worth keeping
}

/// What took hours is not lost by a name used twice.
TEST_F(FolderInUse, ARunThatWouldBeLostIsKeptWithAWordOnWhatToDo) {
  const std::string run = programs + "/blockweir run " + cases + "incline --quiet --out o";
  ASSERT_EQ(shell(run), 0) << text("out");
  const std::string before = text("o/history.csv");
  EXPECT_EQ(shell(run + " --set joint.friction_angle_deg=12"), 2);
  EXPECT_THAT(text("out"),
              HasSubstr("o: found a run of another scene: joint.friction_angle_deg is 20 there and 12 here "
                        "(--set); expected a new folder"));
  std::ofstream(folder / "same.toml") << "# as it was\n" << text(cases + "incline/scene.toml");
  EXPECT_EQ(shell(programs + "/blockweir run same.toml --quiet --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("o: found a run of another scene: its file differs in comments or layout alone"));
  EXPECT_THAT(text("out"), HasSubstr("choose another folder, or remove that run (rm -r o)"));
  EXPECT_EQ(text("o/history.csv"), before);
  EXPECT_EQ(shell(run), 0) << "it is complete, and of the same scene; " << text("out");
  fs::create_directory(folder / "o/checkpoint");
  std::ofstream(folder / "o/checkpoint/solid-7") << "of a run that was killed\n";
  EXPECT_EQ(shell(run), 2);
  EXPECT_THAT(text("out"), HasSubstr("o: found a run of this scene, which was stopped and goes on with \"blockweir "
                                     "resume o\"; expected a new folder"));
  EXPECT_TRUE(fs::exists(folder / "o/checkpoint/solid-7"));
}

TEST_F(FolderInUse, AReportOfARunThatStillWritesIsRefused) {
  const pid_t first = start(long_run + " --quiet", "first");
  ASSERT_TRUE(under_way("o"));
  EXPECT_EQ(shell(programs + "/blockweir report o"), 2);
  EXPECT_THAT(text("out"), HasSubstr(fmt::format(
                               "o: another run writes there, that of process {}; wait until it has ended", first)));
  kill(first, SIGINT);
  EXPECT_EQ(end_of(first, 20), 130) << text("first");
}

TEST_F(FolderInUse, AKilledLimitProcessIsToldWithItsSceneAndARemedy) {
  const pid_t level = start(programs + "/blockweir level " + cases + "brick-dam --out l", "first");
  for (int wait = 0; wait < 200 && !signal_child(level, "limit", "KILL"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(end_of(level, 20), 1);
  EXPECT_THAT(text("first"), HasSubstr("brick-dam: no answer: the limit process was ended by signal 9; the system ends "
                                       "a program by signal 9 where memory runs short: free some, and ask again"));
}

TEST_F(FolderInUse, WhatAKilledLauncherHasLeftRunningKeepsIt) {
  fs::create_directory(folder / "mine");
  const std::string keeper = "exec 9>mine/.lock; flock 9; echo $$ >&9; sleep 250 & echo $! >&2; kill -9 $$";
  const pid_t launcher = start("bash -c '" + keeper + "'", "child");
  EXPECT_EQ(end_of(launcher, 5), 128 + SIGKILL);
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --out mine"), 2);
  EXPECT_THAT(text("out"),
              HasSubstr(fmt::format("that of process {}, which has ended and left others running", launcher)));
  kill(std::stoi(text("child")), SIGKILL);
  for (int wait = 0; wait < 400 && orphan(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --quiet --out mine"), 0) << text("out");
}

/// Of which one is at work, with earlier answers.
TEST_F(FolderInUse, AnAnswersFolderIsLeftAsItIs) {
  ASSERT_EQ(shell(programs + "/blockweir level " + cases + "monolith-slides --out mine"), 0) << text("out");
  const std::string before = text("mine/level.json");
  const pid_t keeper = start("bash -c 'exec 9>mine/.lock; flock 9; echo $$ >&9; echo ready >&2; sleep 250'", "child");
  for (int wait = 0; wait < 400 && text("child").empty(); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  for (const char* question : {"safety ", "level "}) {
    EXPECT_EQ(shell(programs + "/blockweir " + question + cases + "incline --out mine"), 2);
    EXPECT_THAT(text("out"), HasSubstr("mine: another run writes there, that of process"));
  }
  for (const char* file : {"mine/.lock", "mine/scene.toml", "mine/limit.log"}) {
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  }
  EXPECT_EQ(text("mine/level.json"), before);
  kill(keeper, SIGKILL);
}

TEST_F(FolderInUse, ARunThatIsCompleteHasNothingToResume) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --quiet --out o"), 0) << text("out");
  const std::string outcome = nlohmann::json::parse(text("o/summary.json"))["outcome"];
  EXPECT_EQ(shell(programs + "/blockweir resume o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("o: found a run that is complete, its outcome is \"" + outcome + "\""));
  EXPECT_THAT(text("out"),
              HasSubstr("\"blockweir run o/scene.toml --set analysis.duration_s=...\" makes a longer one"));
}

}  // namespace
}  // namespace blockweir::test::folder_in_use_test
