// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// interFoam as the fluid against hydrostatics: walls, slopes, blocks in the water; on two processes.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_test {
namespace {

constexpr double weight = 9810;  // N/m3

/// A wall whose upstream face leans back by `lean` at its height of 10 m.
std::string leaning(double lean) {
  const std::string x = std::to_string(lean);
  return " --set 'block.wall.vertices_m=[[0,0],[8,0],[8,10],[" + x + ",10]]'" +
         " --set 'block.rider.vertices_m=[[6,10],[7,10],[7,11],[6,11]]'";
}

class Wall : public OpenFoam {
 protected:
  struct Errors {
    double force = 0;
    double moment = 0;
    double velocity = 0;  ///< m/s
  };
  /// Relative, with the level at `level_m` in cells whose lines meet 10 m.
  [[nodiscard]] Errors errors(int cells_in_depth, const std::string& level_m, double lean = 0) const {
    const std::string table = "water.upstream_level_m={table=[[0," + level_m + "],[100," + level_m + "],[101,10]]}";
    const std::string more = cells(cells_in_depth) + set(table) + (lean > 0 ? leaning(lean) : "");
    EXPECT_EQ(run(cases + "hydrostatic-wall", "o", more), 0) << text("out");
    const double depth = std::stod(level_m);
    const double force = weight * depth * depth / 2;
    const double moment = -force * depth / 3 * (1 + lean * lean / 100);
    return {std::abs(got("o", "water_force_x_n_per_m") / force - 1), std::abs(got("o", "water_moment_n") / moment - 1),
            velocity("o", 10.0 / cells_in_depth, 0.01)};
  }
};

TEST_F(Wall, StillWaterPressesAsTheFormulaSaysWithItsLevelOnACellFace) {
  const Errors e = errors(20, "10");
  EXPECT_LT(e.force, 1e-6);
  EXPECT_LT(e.moment, 1e-6);
  EXPECT_LT(e.velocity, 1e-3);
}

TEST_F(Wall, StillWaterPressesAsTheFormulaSaysWithItsLevelBetweenCellFaces) {
  const Errors e = errors(20, "9.87");
  EXPECT_LT(e.force, 1e-6);
  EXPECT_LT(e.moment, 1e-6);
  EXPECT_LT(e.velocity, 1e-3);
}

TEST_F(Wall, SlopingFacesOnCellsThatTheyCutFeelTheSame) {
  for (const auto& [cells_in_depth, level] : {std::pair(20, "10"), std::pair(20, "9.87"), std::pair(80, "9.87")}) {
    for (const double lean : {1.0, 2.0, 5.0}) {  // 10:1, 5:1, 2:1
      const Errors e = errors(cells_in_depth, level, lean);
      EXPECT_LT(e.force, 1e-5) << cells_in_depth << ' ' << level << ' ' << lean;
      EXPECT_LT(e.moment, 1e-4) << cells_in_depth << ' ' << level << ' ' << lean;
      EXPECT_LT(e.velocity, 1e-3) << cells_in_depth << ' ' << level << ' ' << lean;
    }
  }
}

/// All figures; with --gtest_also_run_disabled_tests.
TEST_F(Wall, DISABLED_TableOfErrors) {
  std::printf("cells  lean  level   force    moment   velocity m/s\n");
  for (const int n : {20, 40, 80}) {
    for (const double lean : {0.0, 1.0, 2.0, 5.0}) {
      for (const char* level : {"10", "9.87"}) {
        const Errors e = errors(n, level, lean);
        std::printf("%5d %5.2f %6s  %.1e  %.1e  %.1e\n", n, lean / 10, level, e.force, e.moment, e.velocity);
      }
    }
  }
}

class Square : public OpenFoam {
 protected:
  /// A square of 4 m that stands fixed in the water, turned by 15 degrees about (0, 6), in cells of 0.2 m.
  [[nodiscard]] Force float_up(double level_m) const {
    std::ofstream scene(folder / "scene.toml");
    scene << "[analysis]\nduration_s = 0.05\n"
             "[material.stone]\nyoungs_modulus_pa = 5e10\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2500\n"
             "[[block]]\nname = \"ground\"\nmaterial = \"stone\"\nfixed = true\n"
             "vertices_m = [[-10, -1], [10, -1], [10, 0], [-10, 0]]\n"
             "[[block]]\nname = \"square\"\nmaterial = \"stone\"\nfixed = true\nvertices_m = [";
    for (int i = 0; i < 4; ++i) {
      const double angle = (15 + 45 + 90 * i) * M_PI / 180;
      scene << (i > 0 ? ", [" : "[") << std::sqrt(8) * std::cos(angle) << ", " << 6 + std::sqrt(8) * std::sin(angle)
            << "]";
    }
    scene << "]\n"
             "[water]\nmay_overtop = true\nupstream_level_m = "
          << level_m << "\ndownstream_level_m = " << level_m
          << "\n[fluid]\nmodel = \"openfoam\"\ncells_in_depth = " << std::lround(level_m / 0.2)
          << "\nupstream_depths = 0.5\ndownstream_depths = 0.5\n";
    scene.close();
    EXPECT_EQ(run("scene.toml", "o", ""), 0) << text("out");
    return water_force("o", {0, 6}, 3);
  }
};

TEST_F(Square, UnderWaterIsLiftedByTheWeightOfWhatItDisplaces) {
  const double lift = weight * 16;
  const Force f = float_up(10);
  EXPECT_NEAR(f.force.x() / lift, 0, 1e-3);
  EXPECT_NEAR(f.force.y() / lift, 1, 1e-3);
  EXPECT_NEAR(f.moment / (lift * 4), 0, 1e-3);
}

TEST_F(Square, HalfUnderWaterIsLiftedByHalfOfIt) {
  const double lift = weight * 8;
  const Force f = float_up(6);
  EXPECT_NEAR(f.force.x() / lift, 0, 1e-3);
  EXPECT_NEAR(f.force.y() / lift, 1, 1e-3);
  // Of the part of a square, turned by t, under a level line through its centre: integral of x, a^3/24 sin t (1 - tan^2
  // t).
  const double t = 15 * M_PI / 180;
  const double moment = weight * 64 / 24 * std::sin(t) * (1 - std::pow(std::tan(t), 2));
  EXPECT_NEAR((f.moment - moment) / (lift * 4), 0, 1e-3);
}

class TwoProcesses : public OpenFoam {};

/// By a slip of 1 cm, for which 1 s is long enough.
TEST_F(TwoProcesses, FailAtTheHeadAtWhichOneDoes) {
  const std::string more = cells(10) + set("water.upstream_level_m={table=[[0,21.9],[1,22.4]]}") +
                           set("analysis.duration_s=1") + set("analysis.failure_displacement_m=0.01") +
                           set("analysis.stop_at_failure=true");
  EXPECT_EQ(run(cases + "cracked-dam-upper", "one", more), 0) << text("out");
  EXPECT_EQ(run(cases + "cracked-dam-upper", "two", more + set("fluid.processes=2")), 0) << text("out");
  EXPECT_THAT(text("two/openfoam/log.interFoam"), testing::HasSubstr("nProcs : 2"));
  const auto head = [&](const std::string& out) {
    return nlohmann::json::parse(text(out + "/summary.json"))["failure"]["head_m"].get<double>();
  };
  EXPECT_NEAR(head("two") / head("one"), 1, 1e-3);
  for (const double y : {7.5, 18.5}) {
    const Force one = water_force("one", {4, y}, 9);
    const Force two = water_force("two", {4, y}, 9);
    EXPECT_LT((two.force - one.force).norm() / one.force.norm(), 1e-4) << y;
    EXPECT_NEAR(two.moment / one.moment, 1, 1e-4) << y;
  }
}

TEST_F(TwoProcesses, PutTheirResultsTogetherOnRequest) {
  const std::string more = cells(10) + set("analysis.duration_s=0.2") + set("fluid.processes=2");
  EXPECT_EQ(run(cases + "hydrostatic-wall", "parts", more), 0) << text("out");
  EXPECT_FALSE(fs::exists(folder / "parts/openfoam/0.1"));
  EXPECT_EQ(run(cases + "hydrostatic-wall", "whole", more + set("fluid.reconstruct=true")), 0) << text("out");
  for (const char* field : {"alpha.water", "U", "p_rgh"}) {
    EXPECT_TRUE(fs::exists(folder / "whole/openfoam/0.1" / field)) << field;
  }
}

}  // namespace
}  // namespace blockweir::test::openfoam_test
