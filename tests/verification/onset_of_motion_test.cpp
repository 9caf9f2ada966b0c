// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Tilted walls that their joints do not hold move off alike with any step. By sweeps alone the first step throws them:
// a force goes on by one block in each.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "solid/step/solid.hpp"
#include "tests/collapse_scenes.hpp"

namespace blockweir::solid::onset_of_motion_test {
namespace {

double moved_m(const scene::Scene& scene) {
  Solid solid(scene);
  const double dt = scene.analysis.step_s;
  const long steps = std::lround(scene.analysis.duration_s / dt);
  for (long n = 0; n < steps; ++n) solid.advance(static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, {});
  return solid.largest_displacement_m();
}

void expect_alike(const std::string& blocks, double duration_s, double tilt_deg, double within) {
  scene::Scene scene = test::collapse(blocks, duration_s, tilt_deg, 30);
  const double moved = moved_m(scene);
  scene.analysis.step_s /= 4;
  EXPECT_GT(moved, 2e-3);
  EXPECT_NEAR(moved, moved_m(scene), within * moved) << "tilted by " << tilt_deg << " degrees";
}

TEST(OnsetOfMotion, IsAlikeWithAnyStep) {
  for (const double tilt_deg : {9.0, 10.0, 12.0}) expect_alike(test::wall(26, 2, 1), 0.3, tilt_deg, 0.02);
}

TEST(OnsetOfMotion, OfAThousandBricksIsAlikeWithAnyStep) {
  expect_alike(test::wall(50, 20, 1), 0.15, 24, 0.03);
}

}  // namespace
}  // namespace blockweir::solid::onset_of_motion_test
