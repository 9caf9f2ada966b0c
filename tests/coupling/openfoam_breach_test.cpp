// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Open water that finds a way past the structure: a gate that is lifted off its sill, on one process and on two; a weir
// that is pushed away.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_breach_test {
namespace {

class Gate : public OpenFoam {
 protected:
  /// A gate 1 m wide behind 4 m of water, in cells of 0.25 m, that rises by `lift_m` within 0.5 s from `sill_m` above
  /// the ground. One that sinks has a slot in the ground.
  [[nodiscard]] nlohmann::json lift(double lift_m, double sill_m, const std::string& more = "") const {
    const std::string y = std::to_string(sill_m);
    std::ofstream scene(folder / "scene.toml");
    scene << "[analysis]\nduration_s = 0.8\nrigid = \"all\"\nstart = \"unstressed\"\nmax_displacement_ratio = 1\n"
             "[material.steel]\nyoungs_modulus_pa = 2e11\npoissons_ratio = 0.3\ndensity_kg_per_m3 = 7800\n"
             "[[block]]\nname = \"ground\"\nmaterial = \"steel\"\nfixed = true\n"
             "vertices_m = [[-10, -6], [10, -6], [10, 0], "
          << (lift_m < 0 ? "[1, 0], [1, -5], [0, -5], [0, 0], " : "")
          << "[-10, 0]]\n"
             "[[block]]\nname = \"gate\"\nmaterial = \"steel\"\n"
          << "vertices_m = [[0, " << y << "], [1, " << y << "], [1, 6], [0, 6]]\n";
    for (const char* point : {"[0.5, " /* foot */, "[0.5, 6]"}) {
      const bool foot = std::string(point) == "[0.5, ";
      scene << "[[support]]\nblock = \"gate\"\npoint_m = " << (foot ? point + y + "]" : std::string(point))
            << "\ndisplacement_x_m = 0\n";
      if (foot) scene << "displacement_y_m = { table = [[0, 0], [0.5, " << lift_m << "]] }\n";
    }
    scene << "[water]\nupstream_level_m = 4\n"
             "[fluid]\nmodel = \"openfoam\"\nlevel_control = \"free\"\ncells_in_depth = 16\nfloor_m = "
          << (lift_m < 0 ? -3 : 0)
          << "\n"
             "upstream_depths = 1\ndownstream_depths = 1\n";
    scene.close();
    EXPECT_EQ(run("scene.toml", "o", more), 0) << text("out");
    return nlohmann::json::parse(text("o/summary.json"));
  }
};

TEST_F(Gate, ThatIsLiftedLetsWaterThrough) {
  const auto summary = lift(1, 0);
  ASSERT_TRUE(summary.contains("breach"));
  EXPECT_GT(summary["breach"]["time_s"], 0.1);  // a cell after 0.125 s
  EXPECT_LT(summary["breach"]["time_s"], 0.5);
  EXPECT_THAT(text("out"), testing::HasSubstr("open water passes the structure\n"));
}

TEST_F(Gate, OnTwoProcessesLetsItThroughAtTheSameTime) {
  const double one = lift(1, 0)["breach"]["time_s"];
  fs::remove_all(folder / "o");
  const double two = lift(1, 0, set("fluid.processes=2"))["breach"]["time_s"];
  EXPECT_NEAR(two, one, 0.02);
}

/// Water over its crest flows where the gate stood.
TEST_F(Gate, ThatSinksLetsWaterOver) {
  const auto summary = lift(-3, 0, set("analysis.duration_s=1.6"));
  ASSERT_TRUE(summary.contains("breach"));
  EXPECT_GT(summary["breach"]["time_s"], 0.3);  // 4.2 m above the ground
}

TEST_F(Gate, ThatStaysOnItsSillDoesNot) {
  EXPECT_FALSE(lift(0, 0).contains("breach"));
}

TEST_F(Gate, ThatIsOpenFromTheStartBreachesNothing) {
  EXPECT_FALSE(lift(0.5, 1).contains("breach"));
}

class Weir : public OpenFoam {
 protected:
  /// A block that 1.9 m of water pushes away from the start; the warnings of its run.
  [[nodiscard]] std::string warnings(const std::string& more) const {
    std::ofstream(folder / "scene.toml") << R"(
analysis = { duration_s = 0.5, step_s = 0.01, rigid = "all" }
fluid = { model = "openfoam", cells_in_depth = 16 }
joint = { friction_angle_deg = 10 }
water = { upstream_level_m = 1.9 }
material.c = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
[[block]]
name = "bed"
material = "c"
fixed = true
vertices_m = [[-8, -0.5], [8, -0.5], [8, 0], [-8, 0]]
[[block]]
name = "weir"
material = "c"
vertices_m = [[0, 0], [0.8, 0], [0.8, 2], [0, 2]]
)";
    fs::remove_all(folder / "o");
    EXPECT_EQ(run("scene.toml", "o", more), 0) << text("out");
    const auto summary = nlohmann::json::parse(text("o/summary.json"));
    EXPECT_EQ(summary["outcome"], "fails");
    return summary["warnings"].dump();
  }
};

TEST_F(Weir, ThatFailsInWaterWhoseLevelIsSetIsToldWhatLetsThePoolRunOut) {
  const auto told = testing::HasSubstr("the water kept its level while blocks that failed moved up to ");
  EXPECT_THAT(warnings(""), told);
  EXPECT_THAT(warnings(set("fluid.level_control=free")), testing::Not(told));
  EXPECT_THAT(warnings(set("analysis.stop_at_failure=true")), testing::Not(told)) << "it has hardly moved";
}

}  // namespace
}  // namespace blockweir::test::openfoam_breach_test
