// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_block
// The base's acceleration integrated twice, against closed answers.
#include "solid/block/base_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blockweir::solid::base_motion_test {
namespace {

TEST(BaseAxis, RowsAreIntegratedExactly) {
  // 0 before 1 s is held from the first row: a = 2 until 1 s, falls to -4 at 2 s, then holds.
  const BaseAxis axis(scene::TimeTable{.time_s = {1, 2}, .value = {2, -4}});
  EXPECT_DOUBLE_EQ(axis.velocity(0.5), 1);
  EXPECT_DOUBLE_EQ(axis.displacement(0.5), 0.25);
  EXPECT_DOUBLE_EQ(axis.velocity(2), 2 + 2 - 3);
  EXPECT_DOUBLE_EQ(axis.displacement(2), 1 + 2 + 1 - 1);
  EXPECT_DOUBLE_EQ(axis.velocity(3), 1 - 4);
  EXPECT_DOUBLE_EQ(axis.displacement(3), 3 + 1 - 2);
}

TEST(BaseAxis, StepsAreIntegratedExactly) {
  const BaseAxis axis(scene::TimeTable{.time_s = {0, 1}, .value = {2, -2}, .stepwise = true});
  EXPECT_DOUBLE_EQ(axis.velocity(2), 0);
  EXPECT_DOUBLE_EQ(axis.displacement(2), 2);
}

TEST(BaseAxis, ASineIsIntegratedExactly) {
  scene::TimeTable table = scene::TimeTable::constant(0.25);
  table.sine = scene::Sine{3, 5, 0.7};
  const BaseAxis axis(table);
  const double h = 1e-4;
  for (const double t : {0.3, 1.1, 2.7}) {
    EXPECT_NEAR((axis.displacement(t + h) - axis.displacement(t - h)) / (2 * h), axis.velocity(t), 1e-6);
    EXPECT_NEAR((axis.velocity(t + h) - axis.velocity(t - h)) / (2 * h), axis.acceleration(t), 1e-6);
  }
  EXPECT_NEAR(axis.velocity(0), 0, 1e-15);
  EXPECT_NEAR(axis.displacement(0), 0, 1e-15);
}

TEST(BaseMotion, EitherPushesOrCarries) {
  scene::Scene scene;
  EXPECT_EQ(BaseMotion(scene).inertia(1), Point(0, 0));
  scene.base_motion.emplace();
  scene.base_motion->acceleration_y_m_per_s2 = scene::TimeTable::constant(2);
  EXPECT_EQ(BaseMotion(scene).inertia(1), Point(0, 2));
  EXPECT_EQ(BaseMotion(scene).displacement(1), Point(0, 0));
  scene.base_motion->form = scene::BaseForm::support;
  EXPECT_EQ(BaseMotion(scene).inertia(1), Point(0, 0));
  EXPECT_EQ(BaseMotion(scene).displacement(1), Point(0, 1));
  EXPECT_EQ(BaseMotion(scene).velocity(1), Point(0, 2));
}

}  // namespace
}  // namespace blockweir::solid::base_motion_test
