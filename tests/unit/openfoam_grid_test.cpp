// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_openfoam bridge_scene_read
// Meshes and waters that cannot be made from a scene.
#include "fluid/openfoam/grid.hpp"

#include "fluid/openfoam/initial_water.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::openfoam_grid_test {
namespace {

using scene::sample::with;
using testing::HasSubstr;

/// The sample's structure of 4 m on ground at 0 m, behind water.
scene::Scene sample(const std::string& water, const std::string& fluid) {
  const std::string text = with("model = \"hydrostatic\"", "model = \"openfoam\"\n" + fluid,
                                with("upstream_level_m = { table = [[0, 1], [2, 3]] }", water));
  return scene::read_text(text, "s.toml").scene;
}

std::string refusal(const std::string& water, const std::string& fluid) {
  const scene::Scene scene = sample(water, fluid);
  try {
    static_cast<void>(openfoam::initial_water(openfoam::make_grid(scene), scene));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(OpenFoamGrid, WaterBelowTheGroundIsRefused) {
  EXPECT_THAT(refusal("upstream_level_m = -0.5", "floor_m = 0"),
              HasSubstr("the highest level, -0.5 m, lies below the ground, 0 m; expected water that reaches"));
}

TEST(OpenFoamGrid, TooManyCellsAreRefused) {
  EXPECT_THAT(refusal("upstream_level_m = 3", "cells_in_depth = 5000"), HasSubstr("lower cells_in_depth, "));
}

TEST(OpenFoamGrid, ASolitaryWaveNeedsRoomBeforeTheStructure) {
  const std::string wave = "wave = { kind = \"solitary\", height_m = 0.3 }\n";
  EXPECT_EQ(refusal("upstream_level_m = 3", wave + "upstream_depths = 22"), "");
  EXPECT_THAT(refusal("upstream_level_m = 3", wave + "upstream_depths = 2"),
              HasSubstr("before the structure; raise upstream_depths in [fluid] to"));
}

/// Drawn 40 m before the structure and 30 m behind it, 2 m deep, and in a trench of 1 m.
const std::string far_water =
    "initial_water_m = [[[-40, 0], [-30, 0], [-30, 2], [-40, 2]],\n"
    "  [[29, -1], [30, -1], [30, 1], [29, 1]]]\n";

TEST(OpenFoamGrid, TakesInAllDrawnWaterWhereTheSceneStatesNoEnd) {
  const scene::Scene scene = sample("", far_water);
  const openfoam::Grid grid = openfoam::make_grid(scene);
  EXPECT_NEAR(grid.x.front(), -40, 1e-9);
  EXPECT_NEAR(grid.x.back(), 30, 1e-9);
  EXPECT_LE(grid.y.front(), -1 + 1e-9);
  const openfoam::InitialWater water = openfoam::initial_water(grid, scene);
  double area_m2 = 0;
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    const std::size_t i = cell % grid.columns();
    area_m2 += water.fraction[cell] * (grid.x[i + 1] - grid.x[i]) * grid.cell_m;
  }
  EXPECT_NEAR(area_m2, 20 + 2, 1e-9);
}

TEST(OpenFoamGrid, DrawnWaterThatEndsSoonerLeavesTheMeshAsItIs) {
  const std::string near = "initial_water_m = [[[-2, 0], [-1, 0], [-1, 2], [-2, 2]]]\n";
  const openfoam::Grid free = openfoam::make_grid(sample("", near));
  const openfoam::Grid stated = openfoam::make_grid(sample("", near + "upstream_depths = 2\ndownstream_depths = 2"));
  EXPECT_EQ(free.x, stated.x);
  EXPECT_EQ(free.y, stated.y);
}

TEST(OpenFoamGrid, StatedEndsThatCutOffDrawnWaterAreRefusedWithWhatSuffices) {
  const std::string all = "\nupstream_depths = 2\ndownstream_depths = 3\nfloor_m = 0";
  EXPECT_THAT(refusal("", far_water + all),
              testing::AllOf(HasSubstr("s.toml:48: error: 22 of the 22 m2 of water in initial_water_m lie outside "
                                       "OpenFOAM's mesh, which takes in x = -4 to "),
                             HasSubstr("expected a mesh that takes in all of the drawn water; state upstream_depths = "
                                       "20 or more, downstream_depths = "),
                             HasSubstr(", floor_m = -1 in [fluid], or leave these keys out")));
  EXPECT_THAT(refusal("", far_water + "upstream_depths = 17.5"),
              HasSubstr("10 of the 22 m2 of water in initial_water_m lie outside"));
  EXPECT_EQ(refusal("", far_water + "upstream_depths = 20"), "");
}

}  // namespace
}  // namespace blockweir::openfoam_grid_test
