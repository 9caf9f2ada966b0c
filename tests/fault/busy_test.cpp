// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// A partner that computes for long is waited for; one that is stopped or gone is given up, and the launcher says which.
#include <gmock/gmock.h>

#include "tests/processes.hpp"

namespace blockweir::test::busy_test {
namespace {

using testing::HasSubstr;

/// A wall under water whose contacts take a dozen solutions a step, and none once it rests.
class Busy : public Processes {
 protected:
  Busy() {
    std::ofstream(folder / "wall.toml") << R"(
title = "wall"
[analysis]
duration_s = 0.1
step_s = 0.001
start = "unstressed"
sleep = false
[coupling]
window_s = 0.05
[material.rock]
youngs_modulus_pa = 20e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[[block]]
name = "ground"
material = "rock"
fixed = true
vertices_m = [[-5, -1], [25, -1], [25, 0], [-5, 0]]
[[wall]]
name = "w"
material = "rock"
brick_length_m = 1
brick_height_m = 0.5
rows = 8
columns = 12
[water]
upstream_level_m = 2
)";
  }
  [[nodiscard]] nlohmann::json summary(const std::string& run_name) const {
    return nlohmann::json::parse(text(run_name + "/summary.json"));
  }
  [[nodiscard]] static double mean_wait_s(const nlohmann::json& summary) {
    return summary["profile_s"]["fluid_wait"].get<double>() / summary["counts"]["exchanges"].get<double>();
  }
  /// One window after the other, far more than the test lets it make.
  [[nodiscard]] pid_t start_long_run(const std::string& more) const {
    return start(programs + "/blockweir run wall.toml --out o --set analysis.duration_s=50 " + more, "log");
  }
  const std::string run = programs + "/blockweir run wall.toml --out ";
};

TEST_F(Busy, APartnerThatComputesForLongerThanTheTimeOutIsWaitedFor) {
  ASSERT_EQ(shell(run + "patient"), 0) << text("out");
  const double time_out_s = mean_wait_s(summary("patient")) / 3;
  ASSERT_EQ(shell(run + "hasty --set coupling.timeout_s=" + std::to_string(time_out_s)), 0) << text("out");
  EXPECT_GT(mean_wait_s(summary("hasty")), time_out_s);
  EXPECT_EQ(text("hasty/history.csv"), text("patient/history.csv"));
}

TEST_F(Busy, ALongWindowSaysWhereItIsAndEndsWhereAskedTwice) {
  const pid_t pid = start_long_run("--set coupling.window_s=50");
  const auto says = [&] { return text("log").find(" solutions so far\n") != std::string::npos; };
  for (int wait = 0; wait < 600 && !says(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_THAT(text("log"), testing::ContainsRegex("window 0, 0\\.?[0-9]* s: [0-9,]+ solutions so far"));
  kill(pid, SIGINT);
  EXPECT_EQ(end_of(pid, 0.5), -1);  // it may want the checkpoint at the window's end
  kill(pid, SIGINT);
  EXPECT_EQ(end_of(pid, 20), 130) << text("log");
  EXPECT_THAT(text("o/solid.log"), HasSubstr("asked twice to stop, in window 0 at "));
}

TEST_F(Busy, ALongWindowIsLeftSoonWhereAskedOnceUnlessItsCheckpointIsTheOnlyOne) {
  for (const std::string every_s : {"60", "0"}) {
    const pid_t pid = start_long_run("--set coupling.window_s=50 --set output.checkpoint_every_s=" + every_s);
    const auto says = [&] { return text("log").find(" solutions so far\n") != std::string::npos; };
    for (int wait = 0; wait < 600 && !says(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    kill(pid, SIGINT);
    if (every_s == "0") {
      EXPECT_EQ(end_of(pid, 6), -1) << text("log");
      kill(pid, SIGINT);
    }
    EXPECT_EQ(end_of(pid, 20), 130) << text("log");
    EXPECT_THAT(text("o/solid.log"),
                testing::ContainsRegex(every_s == "0" ? "asked twice to stop" : "asked to stop, in window 0 at "));
    fs::remove_all(folder / "o");
    fs::remove(folder / "log");
  }
}

/// The solid leaves one, too, where it was stopped for longer than it would take to leave a window without.
TEST_F(Busy, AStoppedPartnerIsNamedAndLeavesACheckpoint) {
  for (const auto& [victim, more] : {std::pair<std::string, std::string>{"solid", " --set coupling.timeout_s=4"},
                                     {"hydrostatic", " --set coupling.timeout_s=1"},
                                     {"inproc", " --inproc"}}) {
    const pid_t pid = start_long_run("--quiet --set coupling.window_s=0.001" + more);
    ASSERT_TRUE(under_way("o", 3)) << text("log");
    EXPECT_TRUE(signal_child(pid, victim, "STOP"));
    EXPECT_EQ(end_of(pid, 20), 1) << text("log");
    const std::string name = victim == "inproc" ? "solid" : victim;
    EXPECT_THAT(text("log"), HasSubstr("the " + name + " process was stopped (SIGSTOP) and answered no more"));
    EXPECT_THAT(text("log"), HasSubstr("\"blockweir resume o\" continues the run"));
    EXPECT_THAT(text("log"), testing::Not(HasSubstr("ended by signal")));
    EXPECT_FALSE(orphan());
    fs::remove_all(folder / "o");
  }
}

TEST_F(Busy, OfASolidThatWasStoppedBeforeItsFirstCheckpointItIsSaidThatThereIsNone) {
  const pid_t pid = start_long_run("--set coupling.window_s=50 --set coupling.timeout_s=1");
  const auto says = [&] { return text("log").find(" solutions so far\n") != std::string::npos; };
  for (int wait = 0; wait < 600 && !says(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_TRUE(signal_child(pid, "solid", "STOP"));
  EXPECT_EQ(end_of(pid, 20), 1) << text("log");
  EXPECT_THAT(text("log"), HasSubstr("it has no checkpoint yet to resume from: run it anew"));
}

/// In the middle of a window that would take minutes.
TEST_F(Busy, AKilledPartnerIsNamedByTheOneThatItKeptWaiting) {
  const pid_t pid = start_long_run("--quiet --set coupling.window_s=50");
  ASSERT_TRUE(under_way("o", 1)) << text("log");
  EXPECT_TRUE(signal_child(pid, "solid", "KILL"));
  EXPECT_EQ(end_of(pid, 20), 1) << text("log");
  EXPECT_THAT(text("log"), HasSubstr("the solid process was ended by signal 9"));
  EXPECT_FALSE(orphan());
}

TEST_F(Busy, AKilledLauncherLeavesNoProcessInALongWindow) {
  const pid_t pid = start_long_run("--quiet --set coupling.window_s=50");
  ASSERT_TRUE(under_way("o", 1)) << text("log");
  kill(pid, SIGKILL);
  EXPECT_EQ(end_of(pid, 5), 128 + SIGKILL);
  EXPECT_TRUE(orphan());  // it may end its window
  for (int wait = 0; wait < 400 && orphan(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(orphan());
  EXPECT_EQ(summary("o")["outcome"], "stopped");
}

}  // namespace
}  // namespace blockweir::test::busy_test
