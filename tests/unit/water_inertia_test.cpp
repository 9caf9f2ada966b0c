// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// The added-mass guard in a step.
#include "solid/step/water_inertia.hpp"

#include <gtest/gtest.h>

#include "step_sample.hpp"

namespace blockweir::solid {
namespace {

TEST(WaterInertia, PushesWithTheInertiaOfTheAccelerationThatTheWaterAnswers) {
  scene::Scene scene = stones();
  scene.coupling.added_mass_guard = true;
  Sample sample(scene);
  const AddedMasses masses(2, 300 * Eigen::Matrix3d::Identity());
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
  const AddedMasses masses(2, 300 * Eigen::Matrix3d::Identity());
  const std::vector<Eigen::Vector3d> at_rest(2, Eigen::Vector3d::Zero());
  sample.water.begin_window({masses, at_rest, 0});
  sample.begin();
  sample.state.blocks[1].velocity[0] = 2;
  EXPECT_DOUBLE_EQ(sample.water.taken_by_water(sample.island()), 300 * 2 * 2 / 2.);
}

TEST(WaterInertia, IsNoneWhereTheSceneHasTheGuardOff) {
  scene::Scene scene = stones();
  scene.coupling.added_mass_guard = false;
  Sample sample(scene);
  const AddedMasses masses(2, 300 * Eigen::Matrix3d::Identity());
  const std::vector<Eigen::Vector3d> at_rest(2, Eigen::Vector3d::Zero());
  sample.water.begin_window({masses, at_rest, 0});
  EXPECT_FALSE(sample.state.guard.acts());
}

}  // namespace
}  // namespace blockweir::solid
