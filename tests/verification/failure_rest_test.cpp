// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// What has failed is said to rest when all of it does, and is as far as all of it has come.
#include <gtest/gtest.h>

#include "solid/watch/failure_watch.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::failure_rest_test {
namespace {

/// A block falls 0.2 m on to the ground; another, where it is there, falls beside it for ever.
scene::Scene dropped(bool beside_the_ground) {
  auto scene = empty_scene();
  scene.analysis.rigid = scene::Rigid::all;
  scene.analysis.start = scene::Start::unstressed;
  scene.analysis.step_s = 2e-3;
  scene.analysis.failure_displacement_m = 0.01;
  add(scene, {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}, true);
  add(scene, {{0, 0.2}, {1, 0.2}, {1, 1.2}, {0, 1.2}});
  if (beside_the_ground) add(scene, {{7, 0.2}, {8, 0.2}, {8, 1.2}, {7, 1.2}});
  return scene;
}

TEST(FailureRest, IsThatOfAllThatFailed) {
  for (const bool beside : {false, true}) {
    const scene::Scene scene = dropped(beside);
    Solid solid(scene);
    FailureWatch watch(solid);
    watch.look(0, {});
    const double step_s = solid.scene().analysis.step_s;
    for (int n = 0; n < 1000; ++n) {
      solid.advance(n * step_s, (n + 1) * step_s, {});
      watch.look(solid.time_s(), {});
    }
    ASSERT_FALSE(watch.failures().empty());
    EXPECT_EQ(watch.rests_again(), !beside);
    const double falls_m = 9.81 / 2 * 2 * 2;
    EXPECT_NEAR(watch.farthest_failed_m(), beside ? falls_m : 0.2, beside ? 0.05 * falls_m : 1e-3);
  }
}

}  // namespace
}  // namespace blockweir::solid::failure_rest_test
