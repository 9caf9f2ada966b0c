// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// How what falls is said to fall, against motions that are known.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "solid/watch/failure_watch.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::failure_modes_test {
namespace {

/// A slender block on one of its corners, leaning beyond its balance by `beyond` of its slenderness.
scene::Scene leaning(double width_m, double height_m, double beyond) {
  auto scene = empty_scene();
  scene.analysis.rigid = scene::Rigid::all;
  scene.analysis.start = scene::Start::unstressed;
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 80;
  add(scene, {{-90, -9}, {90, -9}, {90, 0}, {-90, 0}}, true);
  const double lean = (1 + beyond) * std::atan(width_m / height_m);
  const Point up(std::sin(lean), std::cos(lean));
  const Point back(-std::cos(lean), std::sin(lean));
  add(scene, {width_m * back, {0, 0}, height_m * up, height_m * up + width_m * back});
  return scene;
}

TEST(FailureModes, WhatTopplesFromOneCornerOverturns) {
  test::Random random(25);
  for (int trial = 0; trial < test::campaign(10); ++trial) {
    const double height_m = random.over_decades(0.3, 30);
    scene::Scene scene = leaning(height_m * random.between(0.2, 0.5), height_m, random.between(0.05, 0.5));
    scene.analysis.failure_displacement_m = 1e-3 * height_m;
    scene.analysis.step_s = 1e-3 * std::sqrt(height_m);
    Solid solid(scene);
    FailureWatch watch(solid);
    watch.look(0, {});
    for (int n = 0; watch.failures().empty() && n < 2000; ++n) {
      solid.advance(n * scene.analysis.step_s, (n + 1) * scene.analysis.step_s, {});
      watch.look(solid.time_s(), {});
    }
    ASSERT_FALSE(watch.failures().empty()) << trial;
    EXPECT_EQ(watch.failures().front().mode, "overturning") << trial;
  }
}

/// On ground in two blocks: the heel's joint opens, and the toe's bears, which limit analysis names, too.
TEST(FailureModes, WhatTurnsOverItsToeIsSaidToTurnOnTheJointThatBears) {
  auto scene = empty_scene();
  scene.analysis.rigid = scene::Rigid::all;
  scene.analysis.gravity_tilt_deg = 25;
  scene.analysis.step_s = 2e-3;
  scene.analysis.failure_displacement_m = 0.01;
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 60;
  add(scene, {{-5, -1}, {1, -1}, {1, 0}, {-5, 0}}, true);
  add(scene, {{1, -1}, {9, -1}, {9, 0}, {1, 0}}, true);
  add(scene, {{0, 0}, {2, 0}, {2, 6}, {0, 6}});
  scene.joints = {{.name = "heel", .between = {0, 2}, .law = scene.default_joint},
                  {.name = "toe", .between = {1, 2}, .law = scene.default_joint}};
  Solid solid(scene);
  FailureWatch watch(solid);
  watch.look(0, {});
  for (int n = 0; watch.failures().empty() && n < 1000; ++n) {
    solid.advance(n * scene.analysis.step_s, (n + 1) * scene.analysis.step_s, {});
    watch.look(solid.time_s(), {});
  }
  ASSERT_FALSE(watch.failures().empty());
  EXPECT_EQ(watch.failures().front().mode, "overturning");
  EXPECT_EQ(watch.failures().front().joint, "heel");
  EXPECT_EQ(watch.failures().front().turns_on, "toe");
}

/// Three blocks on a slope of 20 degrees with this friction, and a crumb far below them that nearly nothing holds.
/// Looks until the crumb is `far` times as far as a failure.
void crumb_slides(double friction_angle_deg, double far, const std::function<void(const FailureWatch&)>& see) {
  auto scene = empty_scene();
  scene.analysis.rigid = scene::Rigid::all;
  scene.analysis.gravity_tilt_deg = 20;
  scene.analysis.step_s = 2e-3;
  scene.analysis.failure_displacement_m = 0.01;
  auto& law = scene.default_joint;
  law.friction_angle_deg = law.residual_friction_angle_deg = friction_angle_deg;
  add(scene, {{-1, -1}, {9, -1}, {9, 0}, {-1, 0}}, true);
  for (const double x : {0.0, 1.0, 2.0}) add(scene, {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}});
  add(scene, {{6, 0}, {6.005, 0}, {6.005, 0.005}, {6, 0.005}});
  scene.joints = {{.name = "smooth", .between = {0, 4}, .law = law}};
  scene.joints[0].law.friction_angle_deg = scene.joints[0].law.residual_friction_angle_deg = 1;
  Solid solid(scene);
  FailureWatch watch(solid);
  watch.look(0, {});
  for (int n = 0; solid.states()[4].displacement[0] < far * scene.analysis.failure_displacement_m; ++n) {
    ASSERT_LT(n, 2000);
    solid.advance(n * scene.analysis.step_s, (n + 1) * scene.analysis.step_s, {});
    watch.look(solid.time_s(), {});
  }
  see(watch);
}

TEST(FailureModes, ACrumbIsNotNamedForTheBlocksThatMoveWithIt) {
  crumb_slides(17, 1.1, [](const FailureWatch& watch) {
    EXPECT_TRUE(watch.failures().empty()) << "the blocks have not gone as far";
    ASSERT_TRUE(watch.moving());
    EXPECT_NE(watch.moving()->block, 4);
  });
  crumb_slides(17, 20, [](const FailureWatch& watch) {
    EXPECT_TRUE(watch.failed());
    ASSERT_EQ(watch.failures().size(), 2U);
    EXPECT_THAT(watch.failures()[0].blocks, testing::ElementsAre(1, 2, 3));
    EXPECT_THAT(watch.failures()[1].blocks, testing::ElementsAre(4));
  });
}

TEST(FailureModes, ACrumbThatSlidesAloneIsSaidToFail) {
  crumb_slides(30, 1.5, [](const FailureWatch& watch) {
    EXPECT_FALSE(watch.failed());
    ASSERT_EQ(watch.failures().size(), 1U);
    EXPECT_THAT(watch.failures()[0].blocks, testing::ElementsAre(4));
  });
}

}  // namespace
}  // namespace blockweir::solid::failure_modes_test
