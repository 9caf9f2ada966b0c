// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// The real programs: cases against their figures, two processes by hand across tcp, what a run leaves.
#include <set>

#include "tests/processes.hpp"

namespace blockweir::test::processes_test {
namespace {

TEST_F(Processes, TheThreeContactFormulationsAreCompared) {
  EXPECT_EQ(shell(programs + "/blockweir compare " + cases + "own-weight --json table.json"), 0) << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr("own-weight, penalty: a run that measures condition numbers, which takes "
                                              "far longer\n"));
  const auto rows = nlohmann::json::parse(text("table.json"));
  ASSERT_EQ(rows.size(), 6U);  // stress and shortening
  for (const auto& row : rows) {
    const bool gives_way = row["formulation"] == "penalty";
    EXPECT_EQ(row["largest_penetration_m"].get<double>() > 1e-9, gives_way) << row;
    EXPECT_LT(row["relative_error"].get<double>(), gives_way ? 1e-2 : 1e-9) << row;
    EXPECT_GT(row["largest_condition_number"].get<double>(), 1) << row;
  }
}

TEST_F(Processes, ASceneWithoutFiguresIsToldHowToStateThem) {
  EXPECT_EQ(shell(programs + "/blockweir validate " + cases + "own-weight --set expect=[]"), 1);
  EXPECT_THAT(text("out"), testing::HasSubstr("no scene states a figure: add [[expect]]"));
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

TEST_F(Processes, AStructureThatStandsSaysHowFarItIsFromSlidingAndOverturning) {
  const std::string run = programs + "/blockweir run " + cases;
  EXPECT_EQ(
      shell(run + "cracked-dam-upper --quiet --out o --set water.upstream_level_m=21 --set analysis.duration_s=1"), 0);
  EXPECT_THAT(text("out"), testing::HasSubstr("STANDS  lowest sliding factor 1.119 on joint \"crack\""));
  auto margin = nlohmann::json::parse(text("o/summary.json"))["margin"];
  EXPECT_NEAR(margin["sliding_factor"].get<double>() / 1.118851, 1, 1e-3);  // N tan(30)/T at a head of 6 m
  EXPECT_EQ(
      shell(run + "monolith-overturns --quiet --out p --set water.upstream_level_m=7.1 --set analysis.duration_s=1"),
      0);
  margin = nlohmann::json::parse(text("p/summary.json"))["margin"];
  // (W B/2 - 2/3 B U - rho g H^3/6)/((W - U) B)
  EXPECT_NEAR(margin["overturning"]["end_distance"].get<double>() / 0.0261417, 1, 0.01);
}

/// What is left of pressure and tension at a wall that holds a beam is round-off, of either sign.
TEST_F(Processes, ABeamIsNotSaidToOverturnByRoundOff) {
  for (const std::string size : {"0.5", "0.45", "0.4", "0.35", "0.3", "0.25", "0.2"}) {
    fs::remove_all(folder / "o");
    EXPECT_EQ(shell(programs + "/blockweir run " + cases +
                    "cantilever --quiet --out o --set block.beam.mesh_size_m=" + size + " --set expect=[]"),
              0)
        << text("out");
    EXPECT_FALSE(nlohmann::json::parse(text("o/summary.json"))["margin"].contains("overturning")) << size;
  }
}

TEST_F(Processes, AnExpectedModeIsToldAsAWord) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases +
                  "incline --quiet --out o --set \"expect=[{quantity='mode',word='overturning'}]\""),
            0)
      << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr("OUT     mode: expected overturning, got sliding"));
}

TEST_F(Processes, InExampleTwoTheLargeBlockSlidesFirstThenAllMove) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "cracked-dam-lower --variant 'all move' --quiet --out o"), 0)
      << text("out");
  std::istringstream history(text("o/history.csv"));
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  const auto cells = [](const std::string& line, const auto& each) {
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) each(cell);
  };
  std::string line;
  std::getline(history, line);
  cells(line, [&](const std::string& name) { names.push_back(name); });
  while (std::getline(history, line)) {
    std::size_t column = 0;
    cells(line, [&](const std::string& cell) { columns[names[column++]].push_back(std::stod(cell)); });
  }
  const auto moved = [&](int block, std::size_t row) {
    return columns["block " + std::to_string(block) + ".displacement_x_m"].at(row);
  };
  EXPECT_GT(moved(2, 300), 0.01);  // rows every 0.01 s
  EXPECT_LT(moved(1, 300), 0.001);
  EXPECT_LT(moved(3, 300), 0.001);
  for (const int block : {1, 2, 3}) EXPECT_GT(moved(block, 1200), 9) << block;
}

TEST_F(Processes, AFastFillingReadsTheLevelToAWindowsRise) {
  for (const double rate : {0.2, 1.0}) {  // m/s; a window is 0.01 s
    fs::remove_all(folder / "o");
    const std::string filling =
        " --set 'water.upstream_level_m={from=21.8,rate_per_s=" + std::to_string(rate) + ",to=22.4}'";
    EXPECT_EQ(shell(programs + "/blockweir run " + cases +
                    "cracked-dam-upper --quiet --out o --set analysis.step_s=0.01 --set analysis.duration_s=4 "
                    "--set analysis.stop_at_failure=true" +
                    filling),
              0);
    const auto head = nlohmann::json::parse(text("o/summary.json"))["failure"]["head_m"].get<double>();
    EXPECT_NEAR(head, 6.99964615, 1.5 * rate * 0.01) << rate;
  }
}

TEST_F(Processes, AStepOfATenthOfAMillisecondFindsTheSameLevel) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases +
                  "cracked-dam-upper --quiet --out o --set analysis.step_s=1e-4 --set analysis.duration_s=3 "
                  "--set analysis.stop_at_failure=true --set 'water.upstream_level_m={table=[[0,21.97],[3,22.12]]}'"),
            0)
      << text("out");
  EXPECT_NEAR(nlohmann::json::parse(text("o/summary.json"))["failure"]["head_m"].get<double>() / 6.99964615, 1, 1e-3);
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

TEST_F(Processes, AFolderOfAFormerRunIsAsGoodAsNew) {
  const auto run = [&](const std::string& scene_and_out) {
    EXPECT_EQ(shell(programs + "/blockweir run " + cases + scene_and_out), 0) << text("out");
  };
  const auto names = [&](const char* name) {
    std::set<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder / name)) {
      all.insert(entry.path().lexically_relative(folder / name));
    }
    return all;
  };
  run("hydrostatic-wall --quiet --out reused --set output.reservoir=true");
  for (const char* draw : {"plot reused --animate", "plot reused --svg", "profile reused", "profile reused --svg"}) {
    EXPECT_EQ(shell(programs + "/blockweir " + draw), 0) << text("out");
  }
  for (const char* left : {"openfoam/system", "checkpoint"}) fs::create_directories(folder / "reused" / left);
  for (const char* left : {"openfoam/water.csv", "openfoam.log", "column.log", "fluid.json", "repeat.toml", "notes"}) {
    std::ofstream(folder / "reused" / left) << "of before\n";
  }
  EXPECT_GT(names("reused").size(), 25U);
  run("own-weight --quiet --out fresh");
  fs::copy(folder / "fresh/scene.toml", folder / "reused/scene.toml", fs::copy_options::overwrite_existing);
  run("own-weight --quiet --out reused");  // that of another scene would be kept
  std::set<std::string> expected = names("fresh");
  expected.insert("notes");  // somebody's own
  EXPECT_EQ(names("reused"), expected);
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

TEST_F(Processes, EveryFluidTakesTheKeysThatTheSolidTakes) {
  const std::string scene = cases + "water-column --set analysis.duration_s=0.5 --endpoint ipc://line";
  const pid_t fluid = start(programs + "/blockweir-column " + scene, "fluid");
  const pid_t solid = start(programs + "/blockweir-solid " + scene + " --out o", "solid");
  EXPECT_EQ(end_of(solid, 60), 0) << text("solid");
  EXPECT_EQ(end_of(fluid, 10), 0) << text("fluid");
}

/// ZeroMQ brings a dozen libraries: a third of the launcher's start, which each run waits for.
TEST_F(Processes, ProgramsWithoutALineDoNotLoadZeroMq) {
  for (const char* program : {"blockweir", "blockweir-limit"}) {
    EXPECT_EQ(shell("ldd " + programs + "/" + program), 0) << text("out");
    EXPECT_THAT(text("out"), testing::Not(testing::HasSubstr("libzmq"))) << program;
  }
}

TEST_F(Processes, PlotDrawsEveryFigure) {
  // A name with what gnuplot might take for markup or for the end of a text.
  const std::string run = "a_run's ^2";
  EXPECT_EQ(shell(programs + "/blockweir run " + cases + "monolith-overturns --quiet --out \"" + run + "\""), 0);
  EXPECT_EQ(shell(programs + "/blockweir plot \"" + run + "\""), 0) << text("out");
  for (const char* name : {"displacements", "velocities", "rotations", "level", "snapshots", "picture"}) {
    const std::string png = text(run + "/" + name + ".png");
    EXPECT_EQ(png.substr(1, 3), "PNG") << name;
    EXPECT_GT(png.size(), 5000U) << name;
  }
}

TEST_F(Processes, CutDrawsTheBlocksWithoutARun) {
  EXPECT_EQ(shell(programs + "/blockweir cut " + cases + "jointed-section --out a_b.png"), 0) << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr(" blocks (1 fixed) of "));
  EXPECT_EQ(text("a_b.png").substr(1, 3), "PNG");
  EXPECT_EQ(shell(programs + "/blockweir cut " + cases + "jointed-section"), 0) << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr("drawn in jointed-section-cut.png")) << "another scene's stays";
  EXPECT_THAT(text("out"), testing::HasSubstr("1 name without room left out"));
  EXPECT_EQ(shell(programs + "/blockweir plot " + cases + "jointed-section/scene.toml"), 2);
  EXPECT_THAT(text("out"), testing::HasSubstr("scene.toml: found a file; expected the folder of a run"));
  EXPECT_EQ(shell(programs + "/blockweir cut " + cases + "jointed-section --out a.pdf"), 2);
  EXPECT_THAT(text("out"), testing::HasSubstr("expected a name that ends in .png or .svg"));
  EXPECT_EQ(shell(programs + "/blockweir cut " + cases + "jointed-section --out no/a.png"), 2);
}

TEST_F(Processes, AStaticAnalysisFindsRestBelowTheLevelOfFailureOnly) {
  for (const auto& [level, holds] : {std::pair{"21.95", true}, std::pair{"22.05", false}}) {
    const std::string run = programs + "/blockweir run " + cases + "cracked-dam-upper --out " + level +
                            " --set analysis.kind=static --set water.upstream_level_m=" + level;
    EXPECT_EQ(shell(run), 0);
    const auto summary = nlohmann::json::parse(text(std::string(level) + "/summary.json"));
    EXPECT_EQ(summary["rest"]["found"], holds);
    EXPECT_EQ(summary["outcome"], holds ? "stands" : "fails");
    EXPECT_THAT(text("out"), testing::HasSubstr(holds ? "STATIC  at rest after" : "STATIC  no equilibrium: "));
  }
}

}  // namespace
}  // namespace blockweir::test::processes_test
