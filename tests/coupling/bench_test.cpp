// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Wall time against error, with the real programs.
#include "tests/block_on_plane.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::bench_test {
namespace {

using testing::HasSubstr;

const std::string expected = "[[expect]]\nquantity = 'displacement_m'\nof = 'block'\nvalue = 0.0737220628028\n";

class Bench : public Processes {
 protected:
  /// A block that slides against drag, which Shi's scheme meets to second order.
  void write_scene(const std::string& bench, const std::string& figure = expected) const {
    std::ofstream(folder / "s.toml") << R"([analysis]
duration_s = 0.3
step_s = 0.01
gravity_tilt_deg = 20
mass_damping_per_s = 5
max_displacement_ratio = 1
rigid = "all"
[joint]
friction_angle_deg = 5
)" << block_on_plane << figure << bench;
  }
  [[nodiscard]] int bench(const std::string& more = "") const {
    return shell(programs + "/blockweir bench s.toml --out b" + more);
  }
  [[nodiscard]] nlohmann::json row() const { return nlohmann::json::parse(text("b/bench.json"))[0]; }
};

TEST_F(Bench, HasThePointsOfItsCurvesAndTheirPicture) {
  write_scene(
      "[[bench]]\nname = 'step'\nkey = 'analysis.step_s'\nvalues = [0.0025, 0.005, 0.02]\n"
      "[[bench]]\nname = 'integrator'\nkey = 'analysis.integrator'\nvalues = ['trapezoidal', 'generalized-alpha']\n"
      "[[order]]\nname = 'order'\nkey = 'analysis.step_s'\nvalues = [0.005, 0.01, 0.02]\n"
      "quantity = 'displacement_m'\nof = 'block'\nvalue = 0.0737220628028\norder = 2\n");
  ASSERT_EQ(bench(), 0) << text("out");
  EXPECT_EQ(row()["points"].size(), 1U + 3 + 2 + 3);
  EXPECT_EQ(row()["figure"], "displacement_m of block");
  EXPECT_LT(row()["points"][1]["relative_error"], row()["points"][3]["relative_error"]);
  const nlohmann::json table = row();
  for (const auto& point : table["points"]) EXPECT_GT(point["wall_time_s"].get<double>(), 0);
  EXPECT_GT(fs::file_size(folder / "b/s.png"), 1000U);
  EXPECT_THAT(text("out"), HasSubstr("s as it stands: error"));
}

TEST_F(Bench, UntimedHasTheErrorsAlone) {
  write_scene("[[bench]]\nname = 'step'\nkey = 'analysis.step_s'\nvalues = [0.0025, 0.02]\n");
  ASSERT_EQ(bench(" --untimed --jobs 2"), 0) << text("out");
  EXPECT_EQ(row()["points"].size(), 3U);
  EXPECT_LT(row()["points"][1]["relative_error"], row()["points"][2]["relative_error"]);
  EXPECT_FALSE(row()["points"][0].contains("wall_time_s"));
  EXPECT_FALSE(fs::exists(folder / "b/s.png"));
}

TEST_F(Bench, WhatSeemsBetterIsRunBesideTheSceneAsItStands) {
  write_scene(
      "[[bench]]\nname = 'few frames'\nset = ['output.frame_every_s=1']\nkey = 'analysis.step_s'\n"
      "values = [0.0005]\n");
  ASSERT_EQ(bench(" --set analysis.step_s=0.0005 --set output.frame_every_s=0.0005"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("NOT on the front:\n    few frames, analysis.step_s=0.0005: error "));
  ASSERT_EQ(row()["bettered_by"].size(), 1U);
  EXPECT_LT(row()["bettered_by"][0]["wall_time_beside"], 0.9);
}

TEST_F(Bench, InShortACurveHasItsEnds) {
  write_scene("[[bench]]\nname = 'step'\nkey = 'analysis.step_s'\nvalues = [0.0025, 0.005, 0.02]\n");
  ASSERT_EQ(bench(" --short"), 0) << text("out");
  EXPECT_EQ(row()["points"].size(), 3U);
}

TEST_F(Bench, WhatIsSetHoldsInAllRuns) {
  write_scene("[[bench]]\nname = 'integrator'\nkey = 'analysis.integrator'\nvalues = ['shi', 'trapezoidal']\n");
  ASSERT_EQ(bench(), 0) << text("out");
  const double before = row()["points"][0]["relative_error"];
  ASSERT_EQ(bench(" --set analysis.step_s=0.001"), 0) << text("out");
  EXPECT_LT(row()["points"][0]["relative_error"].get<double>(), before / 5);
}

TEST_F(Bench, ASettingThatDoesNotRunIsTold) {
  write_scene(
      "[[bench]]\nname = 'residual'\nset = ['analysis.max_displacement_ratio=1e-15']\nkey = 'analysis.step_s'\nvalues "
      "= [0.01]\n");
  EXPECT_EQ(bench(" --short"), 1);
  EXPECT_EQ(row()["failed"].size(), 1U) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("residual, analysis.step_s=0.01: blockweir-solid: "));
  EXPECT_EQ(row()["points"].size(), 1U);
}

TEST_F(Bench, WhatIsWrongIsFoundBeforeAnythingRuns) {
  write_scene("");
  EXPECT_EQ(bench(), 2);
  EXPECT_THAT(text("out"), HasSubstr("s.toml: found no [[bench]]"));
  write_scene("[[bench]]\nname = 'x'\nkey = 'analysis.step_s'\nvalues = [0.01]\n", "");
  EXPECT_EQ(bench(), 2);
  EXPECT_THAT(text("out"), HasSubstr("no figure whose error could be measured"));
  write_scene("[[bench]]\nname = 'x'\nkey = 'analysis.stepp_s'\nvalues = [0.01]\n");
  EXPECT_EQ(bench(), 2);
  EXPECT_THAT(text("out"), HasSubstr("did you mean \"step_s\"?"));
  EXPECT_FALSE(fs::exists(folder / "b"));
}

TEST_F(Bench, SettingsOfTheCasesAreSoundAndOneRunsInShort) {
  int benches = 0;
  for (const auto& entry : fs::directory_iterator(cases)) {
    std::ostringstream scene;
    scene << std::ifstream(entry.path() / "scene.toml").rdbuf();
    if (scene.str().find("[[bench]]") == std::string::npos) continue;
    ++benches;
    EXPECT_EQ(shell(programs + "/blockweir check " + entry.path().string()), 0) << text("out");
  }
  EXPECT_GE(benches, 7);
  ASSERT_EQ(shell(programs + "/blockweir bench --short --out b " + cases + "water-column"), 0) << text("out");
  EXPECT_GT(row()["points"].size(), 12U);
}

TEST_F(Bench, HoldsTheMotionAgainstARunWithFinerSteps) {
  write_scene(
      "[bench_motion]\nuntil_s = 0.2\nfiner = 8\n"
      "[[bench]]\nname = 'step'\nkey = 'analysis.step_s'\nvalues = [0.0025, 0.005, 0.02]\n",
      "");
  ASSERT_EQ(bench(), 0) << text("out");
  EXPECT_THAT(row()["figure"].get<std::string>(), HasSubstr("motion until 0.2 s, by steps 8 times smaller"));
  std::map<std::string, double> error;
  const nlohmann::json points = row()["points"];
  for (const auto& point : points) {
    error[point["setting"]] = point["relative_error"];
    EXPECT_LT(point["energy_gain"].get<double>(), 1e-9);
  }
  const auto step = [&](const std::string& s) { return error.at("analysis.step_s=" + s); };
  EXPECT_GT(step("0.02"), 2 * step("0.005"));
  EXPECT_GT(step("0.005"), 2 * step("0.0025"));
  EXPECT_GT(fs::file_size(folder / "b/s-energy.png"), 1000U);
  write_scene("[bench_motion]\nuntil_s = 0.2\n");
  EXPECT_EQ(bench(), 2);
  EXPECT_THAT(text("out"), HasSubstr("[bench_motion] has no effect without a curve; expected a [[bench]]"));
}

}  // namespace
}  // namespace blockweir::test::bench_test
