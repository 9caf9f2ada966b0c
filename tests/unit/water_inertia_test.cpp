// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// The added-mass guard in a step.
#include "solid/step/water_inertia.hpp"

#include <gtest/gtest.h>

#include "step_sample.hpp"

namespace blockweir::solid::water_inertia_test {
namespace {

TEST(WaterInertia, PushesWithTheInertiaOfTheAccelerationThatTheWaterAnswers) {
  scene::Scene scene = stones();
  scene.coupling.added_mass_guard = true;
  Sample sample(scene);
  const Eigen::Matrix3d of_each = 300 * Eigen::Matrix3d::Identity();
  const AddedMasses masses{of_each, of_each};
  const std::vector<Eigen::Vector3d> at_rest(2, Eigen::Vector3d::Zero());
  const std::vector<Eigen::Vector3d> moving(2, Eigen::Vector3d(0.2, 0, 0));
  sample.water.begin_window({masses, at_rest, 0});
  sample.water.begin_window({masses, moving, 0.1});
  sample.begin();
  const double before = sample.step.trial.external[1][0];
  sample.water.begin_step(0.01);
  EXPECT_NEAR(sample.step.trial.external[1][0] - before, 300 * 0.2 / 0.1, 1e-9);
  EXPECT_FALSE(sample.water.of_meshes());
}

TEST(WaterInertia, TakesTheKineticEnergyOfTheWaterThatABlockPushesAlong) {
  scene::Scene scene = stones();
  scene.coupling.added_mass_guard = true;
  Sample sample(scene);
  const Eigen::Matrix3d of_each = 300 * Eigen::Matrix3d::Identity();
  const AddedMasses masses{of_each, of_each};
  const std::vector<Eigen::Vector3d> at_rest(2, Eigen::Vector3d::Zero());
  sample.water.begin_window({masses, at_rest, 0});
  sample.begin();
  sample.state.blocks[1].velocity[0] = 2;
  EXPECT_DOUBLE_EQ(sample.water.taken_by_water(sample.island()), 300 * 2 * 2 / 2.);
}

TEST(WaterInertia, OfBlocksThatPushTheSameWaterJoinsThem) {
  AddedMasses masses{Eigen::Matrix3d::Zero(), 300 * Eigen::Matrix3d::Identity()};
  EXPECT_TRUE(masses.links().empty());
  masses.own.push_back(Eigen::Matrix3d::Identity());
  masses.pairs = {{0, 1, Eigen::Matrix3d::Ones()}, {0, 2, Eigen::Matrix3d::Ones()}, {1, 2, Eigen::Matrix3d::Ones()}};
  EXPECT_EQ(masses.links(), (std::vector<std::pair<int, int>>{{0, 1}, {0, 2}}));
  const std::vector<Eigen::Vector3d> a{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  EXPECT_EQ(masses.times(a)[1], Eigen::Vector3d(4, 604, 4));
}

TEST(WaterInertia, IsNoneWhereTheSceneHasTheGuardOff) {
  scene::Scene scene = stones();
  scene.coupling.added_mass_guard = false;
  Sample sample(scene);
  const Eigen::Matrix3d of_each = 300 * Eigen::Matrix3d::Identity();
  const AddedMasses masses{of_each, of_each};
  const std::vector<Eigen::Vector3d> at_rest(2, Eigen::Vector3d::Zero());
  sample.water.begin_window({masses, at_rest, 0});
  EXPECT_FALSE(sample.state.guard.acts());
}

}  // namespace
}  // namespace blockweir::solid::water_inertia_test
