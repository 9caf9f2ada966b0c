// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir bridge_scene_read
// The nodes of the reservoir's mesh follow its boundary: the added mass stays as near to its closed form as on meshes
// made anew, where it is off by 7.4e-6 and 7.8e-6. Water is meshed anew where the mesh cannot follow.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/unit/reservoir_dam.hpp"

namespace blockweir::reservoir::reservoir_mesh_motion_test {
namespace {

double added_mass(const wire::Load& load) {
  return load.added_mass[1][0] + load.added_mass[2][0] + 2 * load.added_mass_between[0][0];
}

/// By 1 % of the depth a window, 0.6 of it in all.
TEST(ReservoirMeshMotion, ADamThatSlidesHasTheAddedMassOfAMeshMadeAnew) {
  const scene::Scene scene = dam_of_two();
  ReservoirModel water(scene);
  wire::Load load;
  double worst = 0;
  for (int i = 0; i <= 60; ++i) {
    water.advance(moved(0.2 * i, 0), 0.01 * i, load);
    worst = std::max(worst, std::abs(added_mass(load) / added - 1));
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_EQ(water.report().counts.at("reservoir solutions"), 61);
  EXPECT_LE(water.report().counts.at("reservoir meshes"), 2);
  EXPECT_THAT(water.report().skips, testing::Contains(testing::HasSubstr("meshing the reservoir, ")));
}

/// From 10 to 20 m. At depth H the added mass is 0.5427545 rho H^2.
TEST(ReservoirMeshMotion, ALevelThatRisesHasTheAddedMassOfItsDepth) {
  scene::Scene scene = dam_of_two();
  scene.water.upstream_level_m = {{0, 1}, {10, 20}};
  ReservoirModel water(scene);
  wire::Load load;
  double worst = 0;
  for (int i = 1; i <= 40; ++i) {
    water.advance(moved(0, 0), 0.025 * i, load);
    const double deep = 10 + 0.25 * i;
    worst = std::max(worst, std::abs(added_mass(load) / (0.5427545 * 1000 * deep * deep) - 1));
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_LT(water.report().counts.at("reservoir meshes"), 12);
}

/// The water's section has corners there that are no end of a face.
TEST(ReservoirMeshMotion, WaterUnderAnOverhangAtTheSurfaceMovesWithIt) {
  scene::Scene scene = dam_of_two();
  auto& top = scene.blocks[2].vertices;
  top = {{0, 10}, {16, 10}, {16, 20}, {0, 20}, {0.02, 19.9}, {0, 19.8}, {0.02, 19.7}, {0, 19.6}};
  ReservoirModel water(scene);
  wire::Load load;
  wire::Load anew;
  for (int i = 0; i <= 10; ++i) water.advance(moved(-0.1 * i, 0), 0.01 * i, load);
  EXPECT_EQ(water.report().counts.at("reservoir meshes"), 1);
  ReservoirModel(scene).advance(moved(-1, 0), 0.1, anew);
  EXPECT_NEAR(added_mass(load), added_mass(anew), 2e-5 * added);
}

TEST(ReservoirMeshMotion, WaterIsMeshedAnewWhereOtherFacesAreWet) {
  const scene::Scene scene = dam_of_two();
  ReservoirModel water(scene);
  wire::Load load;
  water.advance(moved(0, 0), 0, load);
  wire::Motion top_slides = moved(0, 0);
  top_slides.displacement.own()[2][0] = 1;  // off the lower block: its top is wet now
  water.advance(top_slides, 0.01, load);
  EXPECT_EQ(water.report().counts.at("reservoir meshes"), 2);
  top_slides.displacement.own()[2][0] = 1.2;
  water.advance(top_slides, 0.02, load);
  EXPECT_EQ(water.report().counts.at("reservoir meshes"), 2);
  wire::Load anew;
  ReservoirModel(scene).advance(top_slides, 0.02, anew);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(load.added_mass[2][i], anew.added_mass[2][i], 1e-4 * std::abs(anew.added_mass[2][i]) + 1) << i;
  }
}

TEST(ReservoirMeshMotion, AFilmOfWaterHasNoMeshAndIsRestored) {
  scene::Scene scene = dam_of_two();
  scene.water.upstream_level_m = scene::TimeTable::constant(0.01);
  ReservoirModel water(scene);
  wire::Load load;
  water.advance(moved(0, 0), 0.01, load);
  ReservoirModel again(scene);
  EXPECT_NO_THROW(again.restore(water.state()));
  wire::Load other;
  water.advance(moved(0.1, 0), 0.02, load);
  again.advance(moved(0.1, 0), 0.02, other);
  EXPECT_EQ(load.pressure_from_pa.values(), other.pressure_from_pa.values());
}

}  // namespace
}  // namespace blockweir::reservoir::reservoir_mesh_motion_test
