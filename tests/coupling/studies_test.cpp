// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Studies with the real programs: a limit, an order and a map, right ones and wrong ones.
#include "tests/processes.hpp"

namespace blockweir::test::studies_test {
namespace {

using testing::HasSubstr;

class Studies : public Processes {
 protected:
  /// A small block on a plane, gravity tilted, with a study.
  void write_scene(const std::string& study) const {
    std::ofstream(folder / "scene.toml") << R"([analysis]
duration_s = 0.3
step_s = 0.01
gravity_tilt_deg = 20
failure_displacement_m = 0.002
stop_at_failure = true
[material.rock]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500
[joint]
friction_angle_deg = 30
[[block]]
name = "plane"
material = "rock"
fixed = true
vertices_m = [[-2, -1], [6, -1], [6, 0], [-2, 0]]
[[wall]]
name = "b"
material = "rock"
rows = 1
columns = 1
brick_length_m = 1.0
brick_height_m = 0.5
[[joints]]
name = "base"
between = ["plane", "b1-1"]
)" << study;
  }
  [[nodiscard]] int study() const { return shell(programs + "/blockweir study scene.toml --out s"); }
  [[nodiscard]] nlohmann::json result(const std::string& name) const {
    return nlohmann::json::parse(text("s/" + name + ".json"));
  }
};

TEST_F(Studies, ALimitIsFoundByBisection) {
  write_scene(
      "[[limit]]\nname = 'slope'\nkey = 'analysis.gravity_tilt_deg'\nfrom = 20\nto = 40\nvalue = 30\ntolerance = "
      "0.02\n");
  ASSERT_EQ(study(), 0) << text("out");
  EXPECT_NEAR(result("slope")["check"]["got"].get<double>(), 30, 0.6);
  EXPECT_GT(fs::file_size(folder / "s/slope.png"), 1000U);
}

TEST_F(Studies, AWrongLimitIsOutAndOneThatIsNotBracketedSaysSo) {
  write_scene(
      "[[limit]]\nname = 'slope'\nkey = 'analysis.gravity_tilt_deg'\nfrom = 20\nto = 40\nvalue = 33\ntolerance = "
      "0.02\n");
  EXPECT_EQ(study(), 1);
  EXPECT_THAT(text("out"), HasSubstr("OUT limit of analysis.gravity_tilt_deg: expected 33"));
  write_scene("[[limit]]\nname = 'slope'\nkey = 'analysis.gravity_tilt_deg'\nfrom = 10\nto = 20\nvalue = 33\n");
  EXPECT_EQ(study(), 1);
  EXPECT_THAT(text("out"), HasSubstr("no limit of analysis.gravity_tilt_deg found: the outcome is"));
}

TEST_F(Studies, AnOrderIsTheSlopeOfTheErrors) {
  // Sliding with drag: a/alpha (t - (1 - exp(-alpha t))/alpha), which Shi's scheme, its drag at mean rates, meets to
  // second.
  write_scene(
      "[[order]]\nname = 'fall'\nset = ['joint.friction_angle_deg=5', 'analysis.stop_at_failure=false', "
      "'analysis.mass_damping_per_s=5', 'analysis.max_displacement_ratio=1', 'analysis.rigid=all']\n"
      "key = 'analysis.step_s'\nvalues = [0.0025, 0.005, 0.01, 0.02]\n"
      "quantity = 'displacement_m'\nof = 'b1-1'\nvalue = 0.0737220628028\norder = 2\ntolerance = 0.1\n");
  ASSERT_EQ(study(), 0) << text("out");
  EXPECT_EQ(result("fall")["runs"].size(), 4U);
}

TEST_F(Studies, SeveralOrdersShareAPicture) {
  const std::string fall =
      "set = ['joint.friction_angle_deg=5', 'analysis.stop_at_failure=false', 'analysis.rigid=all', "
      "'analysis.mass_damping_per_s=5', 'analysis.max_displacement_ratio=1']\nkey = 'analysis.step_s'\n"
      "values = [0.005, 0.01, 0.02]\nquantity = 'displacement_m'\nof = 'b1-1'\nvalue = 0.0737220628028\norder = 2\n";
  write_scene("[[order]]\nname = 'one'\n" + fall);
  ASSERT_EQ(study(), 0) << text("out");
  EXPECT_FALSE(fs::exists(folder / "s/orders.png"));
  write_scene("[[order]]\nname = 'one'\n" + fall + "[[order]]\nname = 'two'\n" + fall);
  ASSERT_EQ(study(), 0) << text("out");
  EXPECT_GT(fs::file_size(folder / "s/orders.png"), 1000U);
}

TEST_F(Studies, AMapOfStability) {
  std::ostringstream scene;
  scene << std::ifstream(cases + "piston-column/scene.toml").rdbuf();
  const std::string piston = scene.str().substr(0, scene.str().find("[[order]]"));
  const std::string map =
      "[[map]]\nname = 'map'\nset = ['coupling.added_mass_guard=false', 'coupling.added_mass_limit=10', "
      "'coupling.on_energy_gain=report', 'analysis.integrator=shi']\nquantity = 'stability'\nof = 'piston'\n"
      "x_key = 'analysis.step_s'\nx_values = [0.001]\ny_key = 'fluid.column.length_m'\ny_values = [0.9, 1.1]\n";
  std::ofstream(folder / "scene.toml") << piston << map << "formula = 'schedule-stability'\n";
  ASSERT_EQ(study(), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("- stable  g grows"));
  std::ofstream(folder / "scene.toml") << piston << map << "word = 'stable'\n";
  EXPECT_EQ(study(), 1);
  EXPECT_THAT(text("out"), HasSubstr("fluid.column.length_m=1.1: grows, expected stable\n"));
}

TEST_F(Studies, AMapOfANumberJudgesByTheTolerance) {
  const std::string map =
      "[[map]]\nname = 'weight'\nquantity = 'reaction_n_per_m'\nof = 'plane'\nx_key = 'analysis.gravity_tilt_deg'\n"
      "x_values = [0, 20]\ny_key = 'wall.b.brick_length_m'\ny_values = [1, 2]\n";
  write_scene(map + "formula = 'weight-of-all'\ntolerance = 1e-8\n");
  ASSERT_EQ(study(), 0) << text("out");
  EXPECT_EQ(result("weight")["check"]["right"], 4);
  write_scene(map + "value = 12262.5\ntolerance = 0.1\n");  // of the level plane, and 6 % more than of the steep one
  EXPECT_EQ(study(), 1);
  EXPECT_EQ(result("weight")["check"]["right"], 2);
  write_scene(map + "quantityy = 1\nvalue = 1\n");
  EXPECT_EQ(study(), 2);
}

TEST_F(Studies, ARunThatEndsOnTheMoveIsMadeLonger) {
  write_scene(
      "[[limit]]\nname = 'slope'\nkey = 'analysis.gravity_tilt_deg'\nset = ['analysis.duration_s=0.05']\nfrom = 20\nto "
      "= 40\nvalue = 30\ntolerance = 0.02\n");
  EXPECT_EQ(study(), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("moving"));
  EXPECT_NEAR(result("slope")["check"]["got"].get<double>(), 30, 0.6);
}

TEST_F(Studies, AMapOfWhatTheSceneHasNotSaysSo) {
  const auto map_of = [&](const std::string& quantity) {
    write_scene(
        "[[map]]\nname = 'm'\nquantity = '" + quantity +
        "'\nx_key = 'analysis.gravity_tilt_deg'\nx_values = [20]\ny_key = 'wall.b.brick_length_m'\ny_values = [1]\n"
        "value = 0\n");
    return study();
  };
  EXPECT_EQ(map_of("displacment_m"), 2);
  EXPECT_THAT(text("out"), HasSubstr("did you mean \"displacement_m\"?"));
  EXPECT_EQ(map_of("point_stress_yy_pa"), 2);
  EXPECT_THAT(text("out"), HasSubstr("point_stress_yy_pa in [[map]] \"m\" needs at_m"));
}

TEST_F(Studies, AnOrderThatCannotBeSaysWhy) {
  const auto order = [&](const std::string& keys) {
    write_scene("[[order]]\nname = 'o'\nkey = 'analysis.step_s'\norder = 1\n" + keys);
    EXPECT_EQ(study(), 1);
    return text("out");
  };
  const std::string weight = "quantity = 'reaction_n_per_m'\nof = 'plane'\nvalue = 1\n";
  EXPECT_THAT(order(weight + "values = [0.01, 0.01, 0.01]\n"), HasSubstr("no order: all values are the same"));
  EXPECT_THAT(order("quantity = 'failure_time_s'\nvalue = 1\nvalues = [0.01, 0.005, 0.002]\n"),
              HasSubstr("no order: the run gave no number for failure_time_s"));
  EXPECT_THAT(order("quantity = 'displacement_m'\nof = 'plane'\nvalue = 0\nvalues = [0.01, 0.005, 0.002]\n"),
              HasSubstr("no order: displacement_m is exact at analysis.step_s = 0.01"));
}

TEST_F(Studies, AMapCountsItsWrongCells) {
  const std::string map =
      "[[map]]\nname = 'modes'\nx_key = 'analysis.gravity_tilt_deg'\nx_values = [20, 40]\n"
      "y_key = 'wall.b.brick_length_m'\ny_values = [0.1, 1.0]\n";
  write_scene(map + "formula = 'slide-or-topple'\nof = 'base'\n");
  ASSERT_EQ(study(), 0) << text("out");
  EXPECT_EQ(result("modes")["runs"].size(), 4U);
  write_scene(map + "word = 'stands'\n");
  EXPECT_EQ(study(), 1);
  EXPECT_THAT(text("out"), HasSubstr("OUT wrong of 4 cells: expected 0, got 3"));
}

TEST_F(Studies, OneThatIsNotThereIsNamed) {
  write_scene("");
  EXPECT_EQ(shell(programs + "/blockweir study scene.toml"), 2);
  EXPECT_THAT(text("out"), HasSubstr("found no study; expected [[study]]"));
}

}  // namespace
}  // namespace blockweir::test::studies_test
