// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// How what falls is said to fall, against motions that are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solid/watch/failure_watch.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid {
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

}  // namespace
}  // namespace blockweir::solid
