// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// The real programs: cases against their figures, two processes by hand across tcp, killed partners, bad scenes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace {

namespace fs = std::filesystem;
const std::string programs = BLOCKWEIR_PROGRAMS;
const std::string cases = std::string(BLOCKWEIR_SOURCE) + "/cases/";

class Processes : public testing::Test {
 protected:
  Processes() {
    std::string name = (fs::temp_directory_path() / "blockweir-test-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~Processes() override { fs::remove_all(folder); }

  [[nodiscard]] std::string text(const std::string& file) const {
    std::ostringstream all;
    all << std::ifstream(folder / file).rdbuf();
    return all.str();
  }
  /// Exit status of a shell command; its output goes to the file "out".
  [[nodiscard]] int shell(const std::string& command) const {
    const int status = std::system(("cd " + folder.string() + " && timeout 120 " + command + " >out 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  }
  [[nodiscard]] pid_t start(const std::string& command, const std::string& log) const {
    const pid_t pid = fork();
    if (pid == 0) {
      const std::string line = "cd " + folder.string() + " && exec " + command + " >" + log + " 2>&1";
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    return pid;
  }
  /// Exit status, or -1 when it still runs after `patience_s`.
  static int end_of(pid_t pid, double patience_s) {
    for (const auto begin = std::chrono::steady_clock::now();
         std::chrono::steady_clock::now() - begin < std::chrono::duration<double>(patience_s);) {
      int status = 0;
      if (waitpid(pid, &status, WNOHANG) == pid)
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return -1;
  }

  fs::path folder;
};

TEST_F(Processes, EveryCaseMeetsItsFigures) {
  EXPECT_EQ(shell(programs + "/blockweir validate " + cases + "*"), 0) << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr("all within tolerance"));
}

TEST_F(Processes, TheLowerCrackFailsFirstUnderOneFillingCurve) {
  const std::string filling =
      " --quiet --set 'water.upstream_level_m={table=[[0,20.0],[12,22.4]]}' --set analysis.stop_at_failure=true";
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "cracked-dam-lower --out lower" + filling), 0) << text("out");
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "cracked-dam-upper --out upper" + filling), 0) << text("out");
  const auto time = [&](const char* run) {
    return nlohmann::json::parse(text(std::string(run) + "/summary.json"))["failure"]["time_s"].get<double>();
  };
  EXPECT_LT(time("lower"), time("upper"));
}

TEST_F(Processes, ABreachIsSaidOnceWaterPassesTheSlidBlock) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "cracked-dam-upper --quiet --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr("BREACH  after "));
  const auto summary = nlohmann::json::parse(text("o/summary.json"));
  EXPECT_GT(summary["breach"]["time_s"], summary["failure"]["time_s"]);
}

TEST_F(Processes, TheReservoirIsWrittenWhereAskedFor) {
  const std::string run = programs + "/blockweir run " + cases + "hydrostatic-wall --quiet --out ";
  EXPECT_EQ(shell(run + "o --set output.reservoir=true"), 0) << text("out");
  EXPECT_THAT(text("o/reservoir.pvd"), testing::HasSubstr("frames/reservoir_000000.vtu"));
  EXPECT_TRUE(fs::exists(folder / "o/frames/reservoir_000000.vtu"));
  EXPECT_EQ(shell(run + "p"), 0);
  EXPECT_FALSE(fs::exists(folder / "p/reservoir.pvd"));
}

TEST_F(Processes, TwoShellsAcrossTcpGiveTheLaunchersResult) {
  const std::string scene = cases + "monolith-slides --set analysis.duration_s=1 --endpoint tcp://127.0.0.1:";
  const std::string port = std::to_string(20000 + getpid() % 20000);
  const pid_t fluid = start(programs + "/blockweir-hydrostatic " + scene + port, "fluid");
  const pid_t solid = start(programs + "/blockweir-solid " + scene + port + " --out byhand", "solid");
  EXPECT_EQ(end_of(solid, 60), 0) << text("solid");
  EXPECT_EQ(end_of(fluid, 10), 0) << text("fluid");
  EXPECT_EQ(
      shell(programs + "/blockweir run " + cases + "monolith-slides --quiet --set analysis.duration_s=1 --out run"), 0);
  EXPECT_EQ(text("byhand/history.csv"), text("run/history.csv"));
}

TEST_F(Processes, ProcessesOfDifferentScenesRefuseEachOther) {
  const std::string end = " --endpoint ipc://" + (folder / "line").string();
  const pid_t fluid = start(programs + "/blockweir-hydrostatic " + cases + "monolith-overturns" + end, "fluid");
  const pid_t solid = start(programs + "/blockweir-solid " + cases + "monolith-slides --out o" + end, "solid");
  EXPECT_EQ(end_of(solid, 30), 1);
  EXPECT_EQ(end_of(fluid, 30), 1);
  EXPECT_THAT(text("solid"), testing::HasSubstr("handshake refused: scene digest: solid has "));
  EXPECT_THAT(text("fluid"), testing::HasSubstr("handshake refused: scene digest: hydrostatic has "));
}

TEST_F(Processes, AKilledPartnerIsNoticedAtTenMomentsOnEitherSide) {
  const std::string end = " --endpoint ipc://" + (folder / "line").string();
  const std::string scene = cases + "cracked-dam-upper --set analysis.step_s=0.001 --set coupling.timeout_s=5";
  for (int moment = 0; moment < 20; ++moment) {
    const bool kill_solid = moment % 2 == 0;
    const pid_t fluid = start(programs + "/blockweir-hydrostatic " + scene + end, "fluid");
    const pid_t solid = start(programs + "/blockweir-solid " + scene + " --out o" + end, "solid");
    for (int wait = 0; wait < 2000 && text("o/history.csv").size() < 2000; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(37 * (moment / 2)));
    kill(kill_solid ? solid : fluid, SIGKILL);
    EXPECT_EQ(end_of(kill_solid ? solid : fluid, 5), 128 + SIGKILL);
    EXPECT_EQ(end_of(kill_solid ? fluid : solid, 6), 1);
    EXPECT_THAT(text(kill_solid ? "fluid" : "solid"), testing::HasSubstr("closed the line in window"));
    if (!kill_solid) {
      EXPECT_EQ(nlohmann::json::parse(text("o/summary.json"))["outcome"], "stopped");
    }
    EXPECT_GT(text("o/history.csv").size(), 2000U);
    fs::remove_all(folder / "o");
  }
}

TEST_F(Processes, CtrlCEndsBothAndLeavesNoOrphan) {
  const pid_t run =
      start(programs + "/blockweir run " + cases + "cracked-dam-upper --out o --set analysis.step_s=0.001", "log");
  for (int wait = 0; wait < 2000 && text("o/history.csv").size() < 2000; ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(run, SIGINT);
  EXPECT_EQ(end_of(run, 10), 130) << text("log");
  EXPECT_THAT(text("log"), testing::HasSubstr("STOPPED"));
  EXPECT_NE(shell("pgrep -f '[b]lockweir-(solid|hydrostatic).*" + folder.filename().string() + "'"), 0) << text("out");
}

TEST_F(Processes, ATakenEndpointIsRefused) {
  const std::string end = " --endpoint ipc://" + (folder / "line").string() + " --set coupling.timeout_s=5";
  const pid_t first = start(programs + "/blockweir-solid " + cases + "monolith-slides --out a" + end, "first");
  for (int wait = 0; wait < 1000 && !fs::exists(folder / "line"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(shell(programs + "/blockweir-solid " + cases + "monolith-slides --out b" + end), 1);
  EXPECT_THAT(text("out"), testing::HasSubstr("another process listens there already"));
  EXPECT_EQ(end_of(first, 20), 1);
  EXPECT_THAT(text("first"), testing::HasSubstr("has not come to ipc://"));
}

TEST_F(Processes, ABadSceneEndsWithStatusTwoAndWritesNothing) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --out o --set analysis.stp_s=1"), 2);
  EXPECT_THAT(text("out"), testing::HasSubstr("step_s"));
  EXPECT_FALSE(fs::exists(folder / "o"));
  EXPECT_EQ(shell(programs + "/blockweir rnu"), 2);
  EXPECT_THAT(text("out"), testing::HasSubstr("did you mean \"run\"?"));
}

TEST_F(Processes, PlotDrawsEveryFigure) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "monolith-overturns --quiet --out o"), 0);
  EXPECT_EQ(shell(programs + "/blockweir plot o"), 0) << text("out");
  for (const char* name : {"displacements", "velocities", "rotations", "level", "snapshots", "picture"}) {
    const std::string png = text("o/" + std::string(name) + ".png");
    EXPECT_EQ(png.substr(1, 3), "PNG") << name;
    EXPECT_GT(png.size(), 5000U) << name;
  }
  EXPECT_EQ(shell(programs + "/blockweir plot nowhere"), 1);
  EXPECT_THAT(text("out"), testing::HasSubstr("is this the folder of a run?"));
}

}  // namespace
