// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_openfoam bridge_scene_read
// Meshes and waters that cannot be made from a scene.
#include "fluid/openfoam/grid.hpp"

#include "fluid/openfoam/initial_water.hpp"
#include "tests/unit/scene_sample.hpp"

namespace {

using namespace blockweir;
using scene::sample::with;
using testing::HasSubstr;

/// The sample's structure of 4 m on ground at 0 m, behind water.
std::string refusal(const std::string& water, const std::string& fluid) {
  const std::string text = with("model = \"hydrostatic\"", "model = \"openfoam\"\n" + fluid,
                                with("upstream_level_m = { table = [[0, 1], [2, 3]] }", water));
  const scene::Scene scene = scene::read_text(text, "s.toml").scene;
  try {
    static_cast<void>(openfoam::initial_water(openfoam::make_grid(scene), scene));
  } catch (const std::invalid_argument& error) {
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

}  // namespace
