// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What goes wrong around interFoam: missing parts, cases that somebody changed, partners that do not fit or die, blocks
// and water that run away. One clear line, a non-zero status on both sides, no process left.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_faults_test {
namespace {

using testing::HasSubstr;

class OpenFoamFaults : public OpenFoam {
 protected:
  const std::string scene =
      cases + "cracked-dam-upper" + cells(10) + set("water.upstream_level_m=21") + set("coupling.timeout_s=4");
  const std::string endpoint = "ipc://" + (folder / "line").string();

  [[nodiscard]] pid_t start_solid(const std::string& more = "") const {
    return start(programs + "/blockweir-solid " + scene + more + " --out o --endpoint " + endpoint, "solid");
  }
  [[nodiscard]] pid_t start_fluid(const std::string& more = "") const {
    return start(programs + "/blockweir-openfoam " + scene + more + " --out of --endpoint " + endpoint, "fluid");
  }
  [[nodiscard]] pid_t start_launcher(const std::string& more = "") const {
    return start(programs + "/blockweir run " + scene + more + " --quiet --out o", "log");
  }
  /// A case as somebody might change it by hand, and interFoam on it.
  void write_case(const std::string& change) const {
    ASSERT_EQ(shell(programs + "/blockweir-openfoam " + scene + " --case-only --out of --endpoint " + endpoint), 0)
        << text("out");
    EXPECT_TRUE(fs::exists(folder / "of/water.foam"));  // ParaView opens the folder by it
    ASSERT_EQ(shell("sh -c \"" + change + "\""), 0) << text("out");
    ASSERT_EQ(shell(std::string("env ") + environment + "blockMesh -case of"), 0) << text("out");
  }
  [[nodiscard]] pid_t start_foam(const std::string& more = "") const {
    return start(std::string("env ") + environment + more + "interFoam -case of", "fluid");
  }
  /// Both have ended with a failure within `patience_s`, and nothing is left.
  void expect_end(pid_t solid, pid_t fluid, double patience_s = 12) const {
    EXPECT_GT(end_of(solid, patience_s), 0) << text("solid");
    EXPECT_GT(end_of(fluid, patience_s), 0) << text("fluid");
    EXPECT_FALSE(orphan());
  }
  /// One line, and that says `what`; lines of progress aside.
  static void expect_line(const std::string& said, const std::string& what) {
    std::istringstream lines(said);
    std::vector<std::string> others;
    for (std::string line; std::getline(lines, line);) {
      const auto has = [&](const char* words) { return line.find(words) != std::string::npos; };
      if (!has("largest displacement") && !has("linear systems solved")) others.push_back(line);
    }
    EXPECT_THAT(others, testing::ElementsAre(HasSubstr(what)));
  }
  /// Id of the process whose program is `name`, that works in this test's folder; 0: none.
  [[nodiscard]] pid_t find(const std::string& name) const {
    for (const auto& process : fs::directory_iterator("/proc")) {
      std::error_code gone;
      const std::string where = fs::read_symlink(process.path() / "cwd", gone).string();
      if (gone || where.rfind(folder.string(), 0) != 0) continue;
      if (fs::read_symlink(process.path() / "exe", gone).filename() == name)
        return std::stoi(process.path().filename());
    }
    return 0;
  }
  /// Until windows have been exchanged.
  [[nodiscard]] bool coupled(const std::string& log) const {
    for (int wait = 0; wait < 2000; ++wait) {
      const std::string said = text(log);
      if (said.find("Time = 0.06") != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
};

TEST_F(OpenFoamFaults, NoInterFoamOnThePath) {
  const pid_t run = start("env PATH=/nowhere " + programs + "/blockweir run " + scene + " --quiet --out o", "log");
  EXPECT_EQ(end_of(run, 12), 1);
  EXPECT_THAT(text("log"), HasSubstr("OpenFOAM's interFoam is not on the PATH; install"));
  EXPECT_FALSE(orphan());
}

TEST_F(OpenFoamFaults, NoPluginBesideThePrograms) {
  fs::create_directory(folder / "bin");
  for (const char* program : {"blockweir", "blockweir-solid", "blockweir-openfoam"}) {
    fs::copy_file(fs::path(programs) / program, folder / "bin" / program);
  }
  const pid_t run = start("bin/blockweir run " + scene + " --quiet --out o", "log");
  EXPECT_EQ(end_of(run, 12), 1);
  EXPECT_THAT(text("log"), HasSubstr("plugin libblockweirOpenFOAM.so is neither in "));
  EXPECT_FALSE(orphan());
}

TEST_F(OpenFoamFaults, ThePluginOfACaseHasGone) {
  write_case("sed -i s,[^\\\\\\\"]*/libblockweir,/nowhere/libblockweir, of/system/controlDict");
  const pid_t solid = start_solid();
  const pid_t foam = start_foam();
  expect_end(solid, foam);
  EXPECT_THAT(text("fluid"), HasSubstr("blockweirBlocks"));
  expect_line(text("solid"), "no connection with ");
}

TEST_F(OpenFoamFaults, AnOptionsFileWithoutTheBlocks) {
  write_case("sed -i /blockweirBlocks/d of/system/fvOptions");
  const pid_t solid = start_solid();
  const pid_t foam = start_foam();
  expect_end(solid, foam);
  EXPECT_THAT(text("fluid"), HasSubstr("system/fvOptions needs an entry of type blockweirBlocks"));
  expect_line(text("solid"), "no connection with ");
}

TEST_F(OpenFoamFaults, AControlDictionaryWithoutTheSchedule) {
  write_case("sed -i /blockweirSchedule/d of/system/controlDict");
  const pid_t solid = start_solid();
  const pid_t foam = start_foam();
  expect_end(solid, foam);
  EXPECT_THAT(text("fluid"), HasSubstr("system/controlDict has no function object of type blockweirSchedule"));
  expect_line(text("solid"), "has no function object of type blockweirSchedule");
}

TEST_F(OpenFoamFaults, AnEndpointWhereNobodyListens) {
  write_case("true");
  const pid_t foam = start_foam("BLOCKWEIR_ENDPOINT=" + endpoint + "s ");
  const pid_t solid = start_solid();
  expect_end(solid, foam);
  EXPECT_THAT(text("fluid"), HasSubstr("no connection with the solid process at " + endpoint + "s within 4 s"));
  expect_line(text("solid"), " at " + endpoint + " within 4 s");
}

TEST_F(OpenFoamFaults, AThirdProcessAtTheEndpoint) {
  const pid_t solid = start_solid(set("analysis.duration_s=60"));
  const pid_t first = start_fluid(set("analysis.duration_s=60"));
  ASSERT_TRUE(coupled("of/log.interFoam")) << text("fluid");
  EXPECT_EQ(shell(programs + "/blockweir-openfoam " + scene + set("analysis.duration_s=60") + " --out of2 --endpoint " +
                  endpoint),
            1);
  expect_line(text("out"), "blockweir-openfoam: interFoam: ");
  EXPECT_EQ(end_of(solid, 0.01), -1) << text("solid");  // those who were there go on
  kill(solid, SIGKILL);
  expect_end(solid, first);
}

TEST_F(OpenFoamFaults, ProcessesOfDifferentScenes) {
  const pid_t solid = start_solid(set("joint.friction_angle_deg=31"));
  const pid_t fluid = start_fluid();
  expect_end(solid, fluid);
  expect_line(text("solid"), "handshake refused: scene digest: solid has ");
  expect_line(text("fluid"), "handshake refused: scene digest: openfoam has ");
}

class OpenFoamKills : public OpenFoamFaults, public testing::WithParamInterface<int> {
 protected:
  [[nodiscard]] static std::string ranks() {
    return set("fluid.processes=" + std::to_string(GetParam())) + set("analysis.duration_s=60") +
           set("coupling.timeout_s=20");  // a busy machine takes a while to make mesh and ranks
  }
};

TEST_P(OpenFoamKills, InterFoam) {
  const pid_t solid = start_solid(ranks());
  const pid_t fluid = start_fluid(ranks());
  ASSERT_TRUE(coupled("of/log.interFoam")) << text("fluid");
  ASSERT_GT(find("interFoam"), 0);
  kill(find("interFoam"), SIGKILL);
  expect_end(solid, fluid);
  expect_line(text("solid"), "closed the line in window");
  expect_line(text("fluid"), "interFoam: ended by signal 9");
}

TEST_P(OpenFoamKills, Solid) {
  const pid_t solid = start_solid(ranks());
  const pid_t fluid = start_fluid(ranks());
  ASSERT_TRUE(coupled("of/log.interFoam")) << text("fluid");
  kill(solid, SIGKILL);
  expect_end(solid, fluid);
  expect_line(text("fluid"), "closed the line in window");
}

TEST_P(OpenFoamKills, Launcher) {
  const pid_t run = start_launcher(ranks());
  ASSERT_TRUE(coupled("o/openfoam/log.interFoam")) << text("log");
  kill(run, SIGKILL);
  EXPECT_EQ(end_of(run, 5), 128 + SIGKILL);
  for (int wait = 0; wait < 1200 && orphan(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_FALSE(orphan());
}

TEST_P(OpenFoamKills, InterFoamUnderTheLauncher) {
  const pid_t run = start_launcher(ranks());
  ASSERT_TRUE(coupled("o/openfoam/log.interFoam")) << text("log");
  ASSERT_GT(find("interFoam"), 0);
  kill(find("interFoam"), SIGKILL);
  EXPECT_EQ(end_of(run, 12), 1);
  EXPECT_THAT(text("log"), HasSubstr("interFoam: ended by signal 9"));
  EXPECT_THAT(text("log"),
              testing::AnyOf(HasSubstr("continues the run"), HasSubstr("no checkpoint yet to resume from")));
  EXPECT_FALSE(orphan());
}

INSTANTIATE_TEST_SUITE_P(Ranks, OpenFoamKills, testing::Values(1, 2));

TEST_F(OpenFoamFaults, ABlockThatLeavesTheMesh) {
  const pid_t run = start_launcher(set("block.top.initial_velocity_m_per_s=[0,40]") + set("analysis.duration_s=5"));
  EXPECT_EQ(end_of(run, 30), 1);
  EXPECT_THAT(text("log"), HasSubstr("block \"top\" leaves the mesh at ("));
  EXPECT_FALSE(orphan());
}

TEST_F(OpenFoamFaults, WaterThatWouldTakeTooManySteps) {
  write_case(
      "sed -i 's/^internalField uniform.*/internalField uniform (300 0 0);/' of/0/U && "
      "sed -i 's/^maxCourant.*/maxCourant 1e-6;/' of/constant/blockweir");
  const pid_t solid = start_solid();
  const pid_t foam = start_foam();
  expect_end(solid, foam);
  expect_line(text("solid"), "the water moves so fast that a window would take over 10,000 steps");
  EXPECT_THAT(text("fluid"), HasSubstr("the water moves so fast that a window would take over 10,000 steps"));
}

TEST_F(OpenFoamFaults, AirBelowNothingOrHeavierThanWater) {
  for (const char* density : {"-1500", "1500"}) {
    write_case("sed -i 's/^air .*/air { transportModel Newtonian; nu 1.48e-05; rho " + std::string(density) +
               "; }/' of/constant/transportProperties");
    const pid_t solid = start_solid();
    const pid_t foam = start_foam();
    expect_end(solid, foam);
    expect_line(text("solid"), "air density: constant/transportProperties has " + std::string(density) + " kg/m3;");
  }
}

TEST_F(OpenFoamFaults, WaterThatDivergesUnderTheLauncher) {
  fs::copy(cases + "own-openfoam-case", folder / "scene", fs::copy_options::recursive);
  ASSERT_EQ(shell("sed -i 's/internalField .*/internalField uniform (1e150 0 0);/' scene/basin/0.orig/U"), 0);
  const pid_t run = start(programs + "/blockweir run scene --quiet --out o", "log");
  EXPECT_EQ(end_of(run, 30), 1);
  EXPECT_THAT(text("log"), HasSubstr("the solution has diverged"));
  EXPECT_FALSE(orphan());
}

TEST_F(OpenFoamFaults, WaterThatDiverges) {
  write_case("sed -i 's/^internalField uniform.*/internalField uniform (1e150 0 0);/' of/0/U");
  const pid_t solid = start_solid();
  const pid_t foam = start_foam();
  expect_end(solid, foam);
  expect_line(text("solid"), "the solution has diverged");
}

/// Where the first step overflows, no word of ours is left but what its end looks like.
TEST_F(OpenFoamFaults, WaterThatOverflowsUnderTheLauncher) {
  fs::copy(cases + "own-openfoam-case", folder / "scene", fs::copy_options::recursive);
  ASSERT_EQ(shell("sed -i 's/nu [^;]*;/nu 1e299;/' scene/basin/constant/transportProperties"), 0);
  ASSERT_EQ(shell("sed -i 's/internalField .*/internalField uniform (1e5 0 0);/' scene/basin/0.orig/U"), 0);
  const pid_t run = start(programs + "/blockweir run scene --quiet --out o", "log");
  EXPECT_EQ(end_of(run, 30), 1);
  EXPECT_THAT(text("log"), HasSubstr("interFoam: a floating point exception: the solution has diverged;"));
  EXPECT_FALSE(orphan());
}

}  // namespace
}  // namespace blockweir::test::openfoam_faults_test
