// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Steps whose contacts are swept, where Newton's method is not let look for them.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/collapse_scenes.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::sweeps_test {
namespace {

scene::Scene block_on_a_floor() {
  auto scene = empty_scene();
  add(scene, {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}, true);
  add(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  scene.analysis.rigid = scene::Rigid::all;
  scene.analysis.start = scene::Start::unstressed;
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 30;
  scene.contact.max_iterations = 2;
  return scene;
}

TEST(Sweeps, HoldsABlockThatStands) {
  const auto scene = block_on_a_floor();
  Solid solid(scene);
  run(solid, 0.1);
  EXPECT_GT(solid.counts().swept_islands, 0);
  EXPECT_LT(solid.states()[1].displacement.norm(), 1e-14);
  double reaction = 0;
  for (const ContactPoint& c : solid.contacts()) reaction += c.force.x();
  EXPECT_NEAR(reaction, 2500 * 9.81, 1e-6);
}

/// x = v t - tan(phi) g t^2/2
TEST(Sweeps, SlowsABlockThatSlides) {
  auto scene = block_on_a_floor();
  scene.blocks[1].initial_velocity_m_per_s = Point(1, 0);
  Solid solid(scene);
  run(solid, 0.1);
  EXPECT_GT(solid.counts().swept_islands, 0);
  EXPECT_NEAR(solid.states()[1].displacement[0], 0.1 - std::tan(std::numbers::pi / 6) * 9.81 * 0.01 / 2, 1e-10);
}

/// A block that falls on its corner is free again after the impact, for no impact throws back.
TEST(Sweeps, StopsABlockThatFalls) {
  auto scene = block_on_a_floor();
  scene.blocks[1].vertices = {{0, 0.01}, {0.8, 0.61}, {0.2, 1.41}, {-0.6, 0.81}};
  Solid solid(scene);
  run(solid, 0.1);
  EXPECT_GT(solid.counts().swept_islands, 0);
  EXPECT_NEAR(solid.state().place(solid.contacts().front()).y(), 0, 1e-9);
}

/// Nothing is solved there: the partner had taken a dam of 4,998 bricks for one that hangs.
TEST(Sweeps, TellOfTheirProgress) {
  const scene::Scene scene = test::collapse(test::wall(20, 3, 1), 1, 20, 30);
  Solid solid(scene);
  long calls = 0;
  solid.call_meanwhile([&] { ++calls; });
  run(solid, 1);
  const Counts& counts = solid.counts();
  ASSERT_GT(counts.swept_islands, 50);
  EXPECT_GT(calls, counts.steps + counts.iterations + 4 * counts.swept_islands);
}

}  // namespace
}  // namespace blockweir::solid::sweeps_test
