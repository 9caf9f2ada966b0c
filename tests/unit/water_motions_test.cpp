// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Motions of blocks that water answers.
#include "solid/block/water_motions.hpp"

#include <gtest/gtest.h>

#include "step_sample.hpp"

namespace blockweir::solid::water_motions_test {
namespace {

scene::Scene meshed_stone() {
  scene::Scene scene = stones(2);
  scene.fluid = scene::FluidModel::reservoir;
  scene.blocks[2].mesh_size_m = 0.5;
  return scene;
}

TEST(WaterMotions, AreThoseOfBlocksTheirStrainsAndCornersOfMeshes) {
  const Sample sample(meshed_stone());
  const WaterMotions& motions = sample.model.water_motions;
  const std::size_t corners = motions.corners().size();
  EXPECT_EQ(corners, sample.model.parts.outlines[2].size());
  EXPECT_EQ(motions.count(), 2 * 3 + corners);
  std::vector<BlockState> states = sample.state.blocks;
  states[1].velocity << 1, 2, 3, 4, 5, 6;
  const auto velocities = motions.velocities(states, motions.count());
  EXPECT_EQ(velocities[1], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(velocities[4], Eigen::Vector3d(4, 5, 6));
}

/// The mesh turns about the origin with 1 rad/s: corners have the velocity of their place.
TEST(WaterMotions, OfCornersAreTheVelocitiesOfTheirPlaces) {
  const Sample sample(meshed_stone());
  const WaterMotions& motions = sample.model.water_motions;
  std::vector<BlockState> states = sample.state.blocks;
  for (const int t : sample.model.parts.triangles[2]) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto part = static_cast<std::size_t>(t);
      const Point x = sample.state.placements[part].position(sample.model.blocks[part].vertices[i]);
      states[part].velocity.segment<2>(2 * static_cast<Eigen::Index>(i)) = perpendicular(x);
    }
  }
  const auto velocities = motions.velocities(states, motions.count());
  double around = 0;
  for (std::size_t k = 0; k < motions.corners().size(); ++k) {
    const OutlineSide& side = motions.corners()[k].side;
    const auto part = static_cast<std::size_t>(side.part);
    const Point x = sample.state.placements[part].position(sample.model.parts.vertex(side));
    EXPECT_LT((velocities[6 + k].head<2>() - perpendicular(x)).norm(), 1e-12);
    around += x.norm();
  }
  EXPECT_GT(around, 1);
}

TEST(WaterMotions, ForcesOnCornersAreForceAndMomentOnTheirBlock) {
  const Sample sample(meshed_stone());
  const WaterMotions& motions = sample.model.water_motions;
  std::vector<Eigen::Vector3d> forces(motions.count(), Eigen::Vector3d::Zero());
  for (std::size_t k = 6; k < forces.size(); ++k) forces[k] = {1, 2, 0};
  std::vector<Eigen::Vector3d> of_blocks(3, Eigen::Vector3d::Zero());
  motions.add_corners(forces, sample.state.placements, of_blocks);
  const auto n = static_cast<double>(motions.corners().size());
  EXPECT_EQ(of_blocks[1], Eigen::Vector3d(0, 0, 0));
  EXPECT_LT((of_blocks[2] - Eigen::Vector3d(n, 2 * n, 0)).norm(), 1e-9);  // a square's corners lie evenly around it
}

TEST(WaterMotions, HaveNoCornersBesideOtherFluids) {
  scene::Scene scene = meshed_stone();
  scene.fluid = scene::FluidModel::hydrostatic;
  const Sample sample(scene);
  EXPECT_TRUE(sample.model.water_motions.corners().empty());
}

}  // namespace
}  // namespace blockweir::solid::water_motions_test
