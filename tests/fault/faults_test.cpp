// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt nlohmann_json::nlohmann_json
// What goes wrong around the real programs: killed partners, taken and wrong endpoints, folders and disks that take
// nothing, scenes that do not fit. One clear line, a non-zero status, results so far readable, no orphan.
#include <fmt/format.h>

#include <fstream>

#include "tests/processes.hpp"

namespace blockweir::test::faults_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Faults = Processes;

TEST_F(Faults, AKilledPartnerIsNoticedAtTenMomentsOnEitherSide) {
  const std::string end = " --endpoint ipc://" + (folder / "line").string();
  const std::string scene = cases + "cracked-dam-upper --set analysis.step_s=0.001 --set coupling.timeout_s=5";
  for (int moment = 0; moment < 20; ++moment) {
    const bool kill_solid = moment % 2 == 0;
    const pid_t fluid = start(programs + "/blockweir-hydrostatic " + scene + end, "fluid");
    const pid_t solid = start(programs + "/blockweir-solid " + scene + " --out o" + end, "solid");
    ASSERT_TRUE(under_way("o"));
    std::this_thread::sleep_for(std::chrono::milliseconds(37 * (moment / 2)));
    kill(kill_solid ? solid : fluid, SIGKILL);
    EXPECT_EQ(end_of(kill_solid ? solid : fluid, 5), 128 + SIGKILL);
    EXPECT_EQ(end_of(kill_solid ? fluid : solid, 6), 1);
    EXPECT_THAT(text(kill_solid ? "fluid" : "solid"), HasSubstr("closed the line in window"));
    if (!kill_solid) {
      EXPECT_EQ(nlohmann::json::parse(text("o/summary.json"))["outcome"], "stopped");
    }
    EXPECT_GT(text("o/history.csv").size(), 2000U);
    fs::remove_all(folder / "o");
  }
}

TEST_F(Faults, CtrlCEndsBothAndLeavesNoOrphan) {
  const pid_t run =
      start(programs + "/blockweir run " + cases + "cracked-dam-upper --out o --set analysis.step_s=0.001", "log");
  ASSERT_TRUE(under_way("o"));
  kill(run, SIGINT);
  EXPECT_EQ(end_of(run, 10), 130) << text("log");
  EXPECT_THAT(text("log"), HasSubstr("STOPPED"));
  EXPECT_FALSE(orphan()) << text("out");
}

/// A wall of 2,000 deformable bricks without gaps, which takes seconds: progress before it stands, and no waiting.
TEST_F(Faults, CtrlCWhileTheStructureSettlesEndsItAtOnce) {
  std::string scene = R"(
title = "wall"
[analysis]
duration_s = 1
step_s = 0.01
rigid = "none"
[material.rock]
youngs_modulus_pa = 20e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[joint]
friction_angle_deg = 31
[[block]]
name = "ground"
material = "rock"
fixed = true
vertices_m = [[-5, -1], [65, -1], [65, 0], [-5, 0]]
)";
  for (int row = 0; row < 36; ++row) {
    for (int i = 0; i < 56; ++i) {
      const double x = row % 2 == 0 ? i : i + 0.5;
      const double y = 0.5 * row;
      scene += fmt::format(
          "[[block]]\nname = \"{}, {}\"\nmaterial = \"rock\"\nvertices_m = [[{}, {}], [{}, {}], [{}, {}], [{}, {}]]\n",
          row, i, x, y, x + 1, y, x + 1, y + 0.5, x, y + 0.5);
    }
  }
  std::ofstream(folder / "wall.toml") << scene;
  const pid_t run = start(programs + "/blockweir run wall.toml --out o", "log");
  const auto settles = [&] { return text("log").find("settling: ") != std::string::npos; };
  for (int wait = 0; wait < 600 && !settles(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ASSERT_TRUE(settles()) << text("log");
  kill(run, SIGINT);
  EXPECT_EQ(end_of(run, 5), 130) << text("log");
  EXPECT_THAT(text("o/solid.log"), HasSubstr("asked to stop while the structure settled"));
  EXPECT_EQ(nlohmann::json::parse(text("o/summary.json"))["stopped"], "stopped on request before its first frame");
  EXPECT_THAT(text("log"), HasSubstr("results o (without a frame; solid.log has the solid's own words)"));
  EXPECT_THAT(text("log"), HasSubstr("it has no checkpoint yet to resume from: run it anew"));
}

/// From before its processes start until after they have ended.
TEST_F(Faults, CtrlCAtAnyMomentLeavesASummaryOrNothing) {
  for (int moment = 0; moment < 40; ++moment) {
    SCOPED_TRACE(moment);
    const pid_t run = start(programs + "/blockweir run " + cases + "monolith-slides --out o", "log");
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * moment));
    kill(run, SIGINT);
    const int status = end_of(run, 20);
    EXPECT_THAT(status, testing::AnyOf(0, 130));
    if (fs::exists(folder / "o/solid.log")) {
      const auto summary = nlohmann::json::parse(text("o/summary.json"));
      EXPECT_EQ(summary.contains("stopped"), status == 130) << text("log");
      EXPECT_GT(summary["wall_time_s"], 0);
      EXPECT_NE(text("log"), "");
    }
    fs::remove_all(folder / "o");
  }
  EXPECT_FALSE(orphan());
}

TEST_F(Faults, ATakenEndpointIsRefused) {
  const std::string end = " --endpoint ipc://" + (folder / "line").string() + " --set coupling.timeout_s=5";
  const pid_t first = start(programs + "/blockweir-solid " + cases + "monolith-slides --out a" + end, "first");
  for (int wait = 0; wait < 1000 && !fs::exists(folder / "line"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(shell(programs + "/blockweir-solid " + cases + "monolith-slides --out b" + end), 1);
  EXPECT_THAT(text("out"), HasSubstr("another process listens there already"));
  EXPECT_EQ(end_of(first, 20), 1);
  EXPECT_THAT(text("first"), HasSubstr("no connection with "));
  EXPECT_FALSE(fs::exists(folder / "line")) << "the socket's file";
  EXPECT_FALSE(fs::exists(folder / "b")) << "a folder of nothing";
}

TEST_F(Faults, ABadSceneEndsWithStatusTwoAndWritesNothing) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --out o --set analysis.stp_s=1"), 2);
  EXPECT_THAT(text("out"), HasSubstr("step_s"));
  EXPECT_FALSE(fs::exists(folder / "o"));
  EXPECT_EQ(shell(programs + "/blockweir rnu"), 2);
  EXPECT_THAT(text("out"), HasSubstr("did you mean \"run\"?"));
}

TEST_F(Faults, ProcessesOfDifferentScenesRefuseEachOther) {
  const std::string end = " --endpoint ipc://" + (folder / "line").string();
  const pid_t fluid = start(programs + "/blockweir-hydrostatic " + cases + "monolith-overturns" + end, "fluid");
  const pid_t solid = start(programs + "/blockweir-solid " + cases + "monolith-slides --out o" + end, "solid");
  EXPECT_EQ(end_of(solid, 30), 1);
  EXPECT_EQ(end_of(fluid, 30), 1);
  EXPECT_THAT(text("solid"), AllOf(HasSubstr("handshake refused: scene digest: solid has "),
                                   HasSubstr("give both the same scene file and the same --set")));
  EXPECT_THAT(text("fluid"), HasSubstr("handshake refused: scene digest: hydrostatic has "));
}

TEST_F(Faults, AFolderThatCannotBeMadeIsRefusedBeforeAnythingStarts) {
  std::ofstream(folder / "file") << "text";
  for (const std::string out : {"file", "file/o", "/proc/o"}) {
    EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --out " + out), 2) << out;
    EXPECT_THAT(text("out"), HasSubstr("blockweir: --out " + out + ": "));
    EXPECT_THAT(text("out"), HasSubstr("expected a folder that can be made and written; choose another --out"));
  }
  EXPECT_EQ(shell(programs + "/blockweir-solid " + cases + "incline --out file/o"), 2);
  EXPECT_EQ(text("file"), "text");
}

TEST_F(Faults, AFolderOfOtherFilesIsNotTouched) {
  fs::create_directory(folder / "mine");
  std::ofstream(folder / "mine/scene.toml") << "mine";
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --out mine"), 2);
  EXPECT_THAT(text("out"), HasSubstr("not empty and not a former run; choose another folder"));
  EXPECT_EQ(text("mine/scene.toml"), "mine");
}

TEST_F(Faults, AReservoirWithoutAFolderForItIsRefused) {
  EXPECT_EQ(shell(programs + "/blockweir-hydrostatic " + cases +
                  "hydrostatic-wall --endpoint ipc://line --set output.reservoir=true"),
            2);
  EXPECT_THAT(text("out"), HasSubstr("[output] reservoir = true, and no --out"));
}

TEST_F(Faults, APlaceForTemporaryFilesThatIsNoneIsNamed) {
  EXPECT_EQ(shell("env TMPDIR=" + folder.string() + "/out " + programs + "/blockweir compare " + cases + "own-weight"),
            1);
  EXPECT_THAT(text("out"), HasSubstr("found no folder for temporary files (Not a directory); TMPDIR, or else /tmp"));
}

TEST_F(Faults, AFileForTheTableThatCannotBeWrittenIsRefusedBeforeAnythingRuns) {
  EXPECT_EQ(shell(programs + "/blockweir validate " + cases + "incline --json no/where.json"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--json no/where.json: "));
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("tolerance")));
}

TEST_F(Faults, AnUnknownVariantIsRefused) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --variant 'frictoin 10 deg' --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("did you mean \"friction 10 deg\"?"));
  EXPECT_FALSE(fs::exists(folder / "o"));
}

TEST_F(Faults, APlotOfNoRunIsRefused) {
  EXPECT_EQ(shell(programs + "/blockweir plot nowhere"), 2);
  EXPECT_THAT(
      text("out"),
      HasSubstr("found no such file, an empty one, or one that you may not read; expected the folder of a run"));
}

TEST_F(Faults, AProgramOfAnotherFluidThanTheScenesIsRefused) {
  EXPECT_EQ(shell(programs + "/blockweir-openfoam " + cases + "incline --out o --case-only"), 2);
  EXPECT_THAT(text("out"), HasSubstr("[fluid] model: found \"none\"; expected \"openfoam\""));
}

TEST_F(Faults, ADiskThatFillsUpEndsTheRunWithOneLine) {
  const std::string run = programs + "/blockweir run " + cases + "cracked-dam-upper --quiet --out ";
  EXPECT_EQ(shell(on_a_full_disk(64, run + "o")), 1);
  EXPECT_THAT(text("out"), HasSubstr("is the disk full, or the folder not writable?")) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("STOPPED"));
  EXPECT_EQ(nlohmann::json::parse(text("o/summary.json"))["outcome"], "stopped");
  EXPECT_GT(text("o/history.csv").size(), 20000U);
  EXPECT_EQ(shell(on_a_full_disk(1, run + "p")), 1);
  EXPECT_THAT(text("out"), HasSubstr("cannot write p/scene.toml"));
  EXPECT_EQ(shell(on_a_full_disk(0, run + "q")), 1);  // not even the message can be written
  EXPECT_FALSE(orphan());
}

TEST_F(Faults, AProcessThatIsKilledIsNamedByTheLauncher) {
  for (const std::string name : {"solid", "hydrostatic"}) {
    const pid_t run = start(
        programs + "/blockweir run " + cases + "cracked-dam-upper --quiet --set analysis.step_s=0.001 --out " + name,
        "log");
    ASSERT_TRUE(under_way(name));
    EXPECT_TRUE(signal_child(run, name, "KILL"));
    EXPECT_EQ(end_of(run, 15), 1) << text("log");
    EXPECT_THAT(text("log"), HasSubstr("the " + name + " process was ended by signal 9"));
    EXPECT_EQ(nlohmann::json::parse(text(name + "/summary.json"))["outcome"], "stopped");
    EXPECT_FALSE(orphan());
  }
}

TEST_F(Faults, AKilledLauncherLeavesNoOrphan) {
  const pid_t run =
      start(programs + "/blockweir run " + cases + "cracked-dam-upper --set analysis.step_s=0.001 --out o", "log");
  ASSERT_TRUE(under_way("o"));
  kill(run, SIGKILL);
  EXPECT_EQ(end_of(run, 5), 128 + SIGKILL);
  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_FALSE(orphan());
  EXPECT_EQ(nlohmann::json::parse(text("o/summary.json"))["outcome"], "stopped");
}

TEST_F(Faults, WhoReadsTheProgressMayLeave) {
  EXPECT_EQ(shell("bash -c '" + programs + "/blockweir-solid " + cases + "brick-rows --out o 2> >(true)'"), 0);
  EXPECT_TRUE(nlohmann::json::parse(text("o/summary.json")).contains("outcome"));
}

TEST_F(Faults, AWrongPortIsSaidWithinTheTimeOut) {
  const std::string scene = cases + "monolith-slides --set coupling.timeout_s=1 --endpoint ";
  EXPECT_EQ(shell(programs + "/blockweir-hydrostatic " + scene + "tcp://127.0.0.1:9"), 1);
  EXPECT_THAT(text("out"), HasSubstr("tcp://127.0.0.1:9"));
  for (const std::string wrong :
       {"tcp://127.0.0.1:notaport", "tcp://", "nonsense", "tcp://127.0.0.1:99999", "tcp://0.0.0.0:5599"}) {
    EXPECT_NE(shell(programs + "/blockweir-solid " + scene + wrong + " --out o"), 0) << wrong;
    EXPECT_THAT(text("out"), HasSubstr(wrong)) << text("out");
    EXPECT_FALSE(fs::exists(folder / "o"));
  }
}

TEST_F(Faults, AnExpectationThatTheSceneCannotAnswerCostsNoResult) {
  const std::string wrong = "expect=[{quantity='displacement_m',formula='contact-period',of='block'}]";
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "incline --set \"" + wrong + "\" --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("OUT     displacement_m of block: [contact] states no stiffness_n_per_m2"));
  const auto summary = nlohmann::json::parse(text("o/summary.json"));
  EXPECT_NE(summary["outcome"], "stopped");
  EXPECT_FALSE(summary["checks"][0]["passed"]);
  EXPECT_GT(summary["counts"]["steps"], 10);
}

TEST_F(Faults, AStartThatFailsLeavesASummaryWithTheWarnings) {
  EXPECT_EQ(
      shell(programs + "/blockweir run " + cases + "own-weight --set material.concrete.youngs_modulus_pa=25 --out o"),
      1);
  const auto summary = nlohmann::json::parse(text("o/summary.json"));
  EXPECT_EQ(summary["outcome"], "stopped");
  EXPECT_THAT(summary["stopped"], HasSubstr("is too soft"));
  EXPECT_THAT(summary["warnings"].dump(), HasSubstr("youngs_modulus_pa"));
}

TEST_F(Faults, ALoadBeyondAllNumbersEndsTheRunAndLeavesASceneThatRepeatsIt) {
  std::ifstream original(cases + "cracked-dam-upper/scene.toml");
  std::ofstream scene(folder / "scene.toml");
  scene << original.rdbuf();
  for (int i = 0; i < 2; ++i) {
    scene << "[[point_load]]\nblock = \"top\"\npoint_m = [0, 22]\n"
             "force_x_n_per_m = { steps = [[0, 0], [0.055, 1.5e308]] }\n";
  }
  scene.close();
  const auto says = HasSubstr("of block \"top\" is not a finite number at 0.06 s (step 3)");
  EXPECT_EQ(shell(programs + "/blockweir run scene.toml --out o"), 1);
  EXPECT_THAT(text("out"), says);
  EXPECT_THAT(text("out"), HasSubstr("\"blockweir run o/repeat.toml\" repeats it"));
  EXPECT_EQ(shell(programs + "/blockweir run o/repeat.toml --out again"), 1);
  EXPECT_THAT(text("out"), says);
  EXPECT_FALSE(fs::exists(folder / "again/hydrostatic.log"));
}

}  // namespace
}  // namespace blockweir::test::faults_test
