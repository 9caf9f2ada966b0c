// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// `blockweir compare` whose runs are stopped or killed.
#include <map>

#include "tests/processes.hpp"

namespace blockweir::test::compare_test {
namespace {

class Compare : public Processes {
 protected:
  [[nodiscard]] pid_t start_compare() const {
    return start("env TMPDIR=" + folder.string() + " " + programs + "/blockweir compare " + cases +
                     "cracked-dam-upper --set analysis.step_s=0.001 --set analysis.duration_s=5 --json table.json",
                 "log");
  }
  /// Until one of the runs, whose scene holds `words`, has written some rows; false when none has within 20 s.
  [[nodiscard]] bool run_under_way(const std::string& words) const {
    for (int wait = 0; wait < 20'000; ++wait, std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
      for (const auto& entry : fs::directory_iterator(folder)) {
        for (const char* name : {"/run", "/run-conditioned"}) {
          const std::string run = entry.path().filename().string() + name;
          if (text(run + "/scene.toml").find(words) != std::string::npos && rows_of(run) > 5) return true;
        }
      }
    }
    return false;
  }
  static pid_t first_child_of(pid_t process) {
    const std::string id = std::to_string(process);
    std::ifstream children("/proc/" + id + "/task/" + id + "/children");
    pid_t first = 0;
    children >> first;
    return first;
  }
};

/// Where no figure is stated, runs are held against each other by how they end.
TEST_F(Compare, TellsHowASceneWithoutFiguresEnds) {
  ASSERT_EQ(shell(programs + "/blockweir compare " + cases + "incline --set expect=[] --json table.json"), 0)
      << text("out");
  const auto rows = nlohmann::json::parse(text("table.json"), nullptr, false);
  ASSERT_EQ(rows.size(), 9U) << text("out");
  for (const auto& row : rows) {
    if (row["name"] == "outcome") EXPECT_EQ(row["got"], "sliding");
    if (row["name"] == "largest_displacement_m") EXPECT_NEAR(row["got"].get<double>(), 0.906407, 1e-5);
  }
}

TEST_F(Compare, KeepsRunsAndSaysHowToRepeatOneThatFailed) {
  ASSERT_EQ(shell(programs + "/blockweir compare " + cases + "incline --out kept --json table.json"), 0) << text("out");
  for (const char* formulation : {"penalty", "lagrange-multiplier", "augmented-lagrangian"}) {
    EXPECT_TRUE(fs::exists(folder / ("kept/incline-" + std::string(formulation)) / "summary.json")) << formulation;
  }
  EXPECT_THAT(text("table.json"), testing::HasSubstr("--set 'contact.formulation=penalty'"));
  EXPECT_EQ(shell(programs + "/blockweir compare " + cases + "incline --set analysis.step_s=-1"), 1);
  EXPECT_THAT(text("out"),
              testing::AllOf(testing::HasSubstr("above 0"), testing::HasSubstr("repeat it with blockweir")));
}

/// Of whatever kind: each has its reason and the command that makes the run, and none leaves a folder behind.
TEST_F(Compare, HasTheReasonOfEachMissingRunAndLeavesNothingOfIt) {
  const struct {
    std::string words;
    const char* reason;
  } missing[] = {{cases + "incline --set analysis.step_s=-1", "step_s in [analysis] is -1; expected a number above 0"},
                 {cases + "incline --set joint.friction=3", "unknown key \"friction\" in [joint]; expected one of"}};
  for (const auto& [words, reason] : missing) {
    ASSERT_EQ(shell(programs + "/blockweir compare " + words + " --out kept --json table.json"), 1) << text("out");
    const auto rows = nlohmann::json::parse(text("table.json"), nullptr, false);
    ASSERT_EQ(rows.size(), 3U) << text("out");
    for (const auto& row : rows) {
      EXPECT_THAT(row["trouble"].get<std::string>(), testing::HasSubstr(reason));
      EXPECT_THAT(row["command"].get<std::string>(),
                  testing::AllOf(
                      testing::StartsWith("blockweir run "),
                      testing::HasSubstr("--set 'contact.formulation=" + row["formulation"].get<std::string>() + "'")));
    }
    EXPECT_FALSE(fs::exists(folder / "kept"));
  }
}

TEST_F(Compare, RefusesScenesThatAreNoneOnceAndBeforeAnyRun) {
  for (const std::string fluids : {"", " --fluids reservoir,hydrostatic"}) {
    const std::string words = cases + "incline nowhere.toml" + fluids;
    EXPECT_EQ(shell(programs + "/blockweir compare " + words + " --out kept --json table.json"), 2);
    EXPECT_EQ(text("out"),
              "nowhere.toml: error: there is no such file; expected a scene file, or a folder that holds scene.toml; "
              "check the path\n");
    EXPECT_FALSE(fs::exists(folder / "kept"));
    EXPECT_FALSE(fs::exists(folder / "table.json"));
  }
}

/// Still water does not answer: the dam slips by a sixth of the way.
TEST_F(Compare, SetsFluidsSideBySide) {
  ASSERT_EQ(shell(programs + "/blockweir compare " + cases +
                  "reservoir-slide --fluids reservoir,hydrostatic --out kept "
                  "--json table.json"),
            0)
      << text("out");
  EXPECT_TRUE(fs::exists(folder / "kept/reservoir-slide-hydrostatic/summary.json"));
  const auto rows = nlohmann::json::parse(text("table.json"), nullptr, false);
  std::map<std::string, std::map<std::string, double>> got;  // by figure and fluid
  for (const auto& row : rows) {
    if (row["got"].is_number()) got[row["name"]][row["fluid"]] = row["got"];
    EXPECT_GT(row["wall_time_s"].get<double>(), 0);
  }
  EXPECT_NEAR(got.at("displacement_m of base").at("reservoir"), 0.0722, 1e-4);
  EXPECT_NEAR(got.at("displacement_m of base").at("hydrostatic"), 0.0118, 1e-4);
  const auto& range = got.at("half the range of water_force_x_n_per_m on dam");
  EXPECT_LT(range.at("hydrostatic"), 1e-3 * range.at("reservoir"));
  EXPECT_THAT(text("out"), testing::HasSubstr("*: off the figure of reservoir, in percent"));
  EXPECT_THAT(text("out"),
              testing::ContainsRegex("half the range of water_force_x_n_per_m on dam .* -(99[.][0-9]*|100) %[*]"));
}

TEST_F(Compare, RefusesAFluidThatIsNone) {
  EXPECT_EQ(shell(programs + "/blockweir compare " + cases + "reservoir-slide --fluids resevoir"), 2);
  EXPECT_THAT(text("out"), testing::HasSubstr("--fluids: found \"resevoir\"; expected one of none, hydrostatic, "
                                              "reservoir, openfoam, column, external; did you mean \"reservoir\"?"));
  EXPECT_EQ(shell(programs + "/blockweir compare --fluids reservoir"), 2);
  EXPECT_THAT(text("out"), testing::HasSubstr("found no scene beside it"));
}

/// 2 cells are too few: interFoam need not run.
TEST_F(Compare, AKeyOfOneFluidActsOnItAlone) {
  const std::string command =
      programs + "/blockweir compare " + cases + "reservoir-slide --set fluid.cells_in_depth=2 ";
  EXPECT_EQ(shell(command + "--fluids hydrostatic,reservoir,openfoam"), 1);
  EXPECT_THAT(text("out"),
              testing::HasSubstr("  openfoam\n    --set fluid.cells_in_depth=2: error: cells_in_depth in [fluid] is "
                                 "2"));
  EXPECT_THAT(text("out"), testing::HasSubstr("    without fluid.cells_in_depth=2, which only openfoam has\n"));
  EXPECT_THAT(text("out"), testing::ContainsRegex("displacement_m of base +0.07"));
  EXPECT_EQ(shell(command + "--fluids hydrostatic,reservoir"), 2);
  EXPECT_THAT(text("out"),
              testing::HasSubstr("--set fluid.cells_in_depth=2: found a key of model = \"openfoam\", which is not "
                                 "compared; expected keys of hydrostatic, reservoir; add openfoam to --fluids"));
}

TEST_F(Compare, RefusesOneFluidAlone) {
  EXPECT_EQ(shell(programs + "/blockweir compare " + cases + "reservoir-slide --fluids reservoir"), 2);
  EXPECT_THAT(text("out"), testing::HasSubstr("--fluids: found \"reservoir\" alone; expected two models or more"));
}

/// Of a wall of many bricks only those that the water presses most have rows; the file has all.
TEST_F(Compare, PrintsTheBlocksThatTheWaterPressesMost) {
  std::ofstream(folder / "wall.toml") << R"(
analysis = { duration_s = 0.02, step_s = 0.01 }
joint = { friction_angle_deg = 35 }
material.brick = { youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 1900 }
water = { upstream_level_m = 0.5 }
[[block]]
name = "ground"
material = "brick"
fixed = true
vertices_m = [[-6, -2], [20, -2], [20, 0], [-6, 0]]
[[wall]]
name = "w"
material = "brick"
brick_length_m = 0.6
brick_height_m = 0.12
rows = 6
columns = 1
)";
  EXPECT_EQ(shell(programs + "/blockweir compare wall.toml --fluids hydrostatic,reservoir --json all.json"), 0)
      << text("out");
  const auto count = [&](const std::string& file, const std::string& words) {
    const std::string all = text(file);
    int found = 0;
    for (auto at = all.find(words); at != std::string::npos; at = all.find(words, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("out", "largest water_force_x_n_per_m on"), 6) << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr("more blocks with less of the water's force are in the file of --json"));
  EXPECT_GE(count("all.json", "largest water_force_x_n_per_m on"), 12);
}

TEST_F(Compare, EndsAtCtrlC) {
  const pid_t compare = start_compare();
  ASSERT_TRUE(run_under_way("[analysis]"));
  kill(compare, SIGINT);
  EXPECT_EQ(end_of(compare, 10), 130) << text("log");
  EXPECT_THAT(text("log"), testing::HasSubstr("stopped on request"));
  EXPECT_FALSE(fs::exists(folder / "table.json"));
  EXPECT_FALSE(orphan());
}

TEST_F(Compare, SaysThatTheRunWithConditionNumbersFailed) {
  const pid_t compare = start_compare();
  ASSERT_TRUE(run_under_way("measure_condition = true"));
  const pid_t solid = first_child_of(compare);
  ASSERT_GT(solid, 0);
  kill(solid, SIGKILL);
  const auto told = [&] { return text("log").find("measure_condition") != std::string::npos; };
  for (int wait = 0; wait < 10'000 && !told(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_THAT(text("log"), testing::HasSubstr("  penalty\n    with contact.measure_condition: the solid "
                                              "process was ended by signal 9\n"));
  kill(compare, SIGINT);
  EXPECT_EQ(end_of(compare, 10), 130) << text("log");
}

}  // namespace
}  // namespace blockweir::test::compare_test
