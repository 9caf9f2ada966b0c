// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// The scene that repeats what broke a run off.
#include "bridge/scene/repeat.hpp"

#include <gtest/gtest.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_repeat_test {
using namespace blockweir::scene;

namespace {

TEST(SceneRepeat, IsCutShortAndHasTheWaterAsPressures) {
  const Scene scene = read_text(sample::text, "s.toml").scene;
  FacePressure water{.block = 1, .from_m = Point(0, 2), .to_m = Point(0, 0.1)};
  water.pressure_from_pa = TimeTable::constant(0);
  water.pressure_to_pa = TimeTable::constant(18639.000000000004);
  const std::string text = repeat_text(scene, 0.05, {water});
  const Scene again = read_text(text, "repeat.toml").scene;
  EXPECT_EQ(again.analysis.duration_s, 0.05);
  EXPECT_EQ(again.fluid, FluidModel::none);
  ASSERT_EQ(again.face_pressures.size(), 2u);
  EXPECT_EQ(again.face_pressures[1], water);
  EXPECT_EQ(again.blocks.size(), scene.blocks.size());
  EXPECT_EQ(again.point_loads, scene.point_loads);
  EXPECT_TRUE(again.expectations.empty());
}

TEST(SceneRepeat, HasNeitherUpliftNorLoadsOfFixedBlocks) {
  const Scene scene = read_text(sample::with("cohesion_pa = 1e5", "uplift = \"full\"",
                                             sample::with("[joint]", "[joint]\nuplift = \"full\"")),
                                "s.toml")
                          .scene;
  FacePressure water{.block = 0, .from_m = Point(8, 0), .to_m = Point(3, 0)};
  water.pressure_from_pa = water.pressure_to_pa = TimeTable::constant(1);
  const Scene again = read_text(repeat_text(scene, 0.05, {water}), "repeat.toml").scene;
  EXPECT_EQ(again.default_joint.uplift, Uplift::none);
  EXPECT_EQ(again.joints[0].law.uplift, Uplift::none);
  EXPECT_EQ(again.face_pressures.size(), 1u);
}

TEST(SceneRepeat, OfEveryCaseIsRead) {
  int cases = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(BLOCKWEIR_SOURCE) + "/cases")) {
    // The floating block hangs in the air where there is no water.
    if (entry.path().extension() != ".toml" || entry.path().parent_path().filename() == "floating-block") continue;
    const Scene scene = read(entry.path()).scene;
    try {
      const Scene again = read_text(repeat_text(scene, scene.analysis.step_s, {}), "repeat.toml").scene;
      EXPECT_EQ(again.blocks.size(), scene.blocks.size());
    } catch (const SceneError& error) {
      ADD_FAILURE() << entry.path() << '\n' << error.what();
    }
    ++cases;
  }
  EXPECT_GT(cases, 40);
}

TEST(SceneRepeat, WithoutWaterOnlyTheDurationDiffers) {
  const Scene scene = read_text(
                          "[analysis]\nduration_s = 3\n[material.m]\nyoungs_modulus_pa = 1e9\npoissons_ratio = 0.2\n"
                          "density_kg_per_m3 = 1\n[[block]]\nname = \"b\"\nmaterial = \"m\"\nfixed = true\n"
                          "vertices_m = [[0, 0], [1, 0], [0, 1]]\n",
                          "s.toml")
                          .scene;
  const Scene again = read_text(repeat_text(scene, 0.5, {}), "repeat.toml").scene;
  EXPECT_EQ(again.analysis.duration_s, 0.5);
  EXPECT_TRUE(again.face_pressures.empty());
}

}  // namespace
}  // namespace blockweir::scene_repeat_test
