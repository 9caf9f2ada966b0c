// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_checkpoint
// What a scene does not need is not done, and the answer is the same: islands apart, sleep, rigid blocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "bridge/checkpoint/archive.hpp"
#include "tests/large_scenes.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::skips_test {
namespace {

/// Two stacks on one floor, far from each other; the left one stands, the right one is hit after 0.5 s.
scene::Scene two_stacks() {
  auto scene = empty_scene();
  scene.analysis.step_s = 0.01;
  add(scene, {{-9, -1}, {19, -1}, {19, 0}, {-9, 0}}, true);
  for (const double x : {0.0, 10.0}) {
    for (int row = 0; row < 4; ++row)
      add(scene, {{x, row * 1.0}, {x + 2, row * 1.0}, {x + 2, row + 1.0}, {x, row + 1.0}});
  }
  scene::PointLoad push{.block = 8, .point_m = Point(10, 3.5)};
  push.force_x_n_per_m = {.time_s = {0, 0.5, 0.51}, .value = {0, 0, 40e3}};
  push.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads.push_back(push);
  return scene;
}

struct Result {
  std::vector<Vector6> displacement;
  Counts counts;
};

Result result_of(const scene::Scene& scene, double duration_s = 1.5) {
  Solid solid(scene);
  solid.settle({});
  run(solid, duration_s);
  Result result{.displacement = {}, .counts = solid.counts()};
  for (const BlockState& state : solid.states()) result.displacement.push_back(state.displacement);
  return result;
}

double largest_difference(const Result& a, const Result& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.displacement.size(); ++i) {
    largest = std::max(largest, (a.displacement[i] - b.displacement[i]).cwiseAbs().maxCoeff());
  }
  return largest;
}

TEST(Skips, SleepingIslandsLeaveTheAnswerAsItIs) {
  auto scene = two_stacks();
  const Result with = result_of(scene);
  scene.analysis.sleep = false;
  const Result without = result_of(scene);
  EXPECT_GT(with.counts.slept_islands, 150);  // the left stack nearly always, the right one until it is pushed
  EXPECT_EQ(without.counts.slept_islands, 0);
  EXPECT_LT(with.counts.solved_islands, without.counts.solved_islands);
  EXPECT_LE(with.counts.iterations, without.counts.iterations);  // what rests finds its forces in balance as it is
  EXPECT_GT(with.displacement[8][0], 0.1);                       // pushed off
  EXPECT_LT(largest_difference(with, without), 1e-9);
}

/// With long steps Shi's scheme lets velocities change sign for hundreds of steps after a load has changed, while the
/// blocks stand.
TEST(Skips, ALongStepDoesNotKeepBlocksAwakeThatStand) {
  auto scene = two_stacks();
  scene.analysis.step_s = 0.05;
  scene.point_loads[0].force_x_n_per_m = {.time_s = {0, 0.5, 0.51}, .value = {0, 0, 20}};
  EXPECT_GT(result_of(scene, 5).counts.slept_islands, 150);  // of two in 100 steps
}

/// While the stack settles one block waits in the air and one lies on the ground, both with a speed to begin with.
TEST(Skips, WhatMovesFromTheStartIsNotAsleepWhenTheRestHasSettled) {
  auto scene = empty_scene();
  scene.analysis.step_s = 0.01;
  add(scene, {{-9, -1}, {19, -1}, {19, 0}, {-9, 0}}, true);
  for (int row = 0; row < 3; ++row) add(scene, {{0, row * 1.0}, {1, row * 1.0}, {1, row + 1.0}, {0, row + 1.0}});
  add(scene, {{4, 3}, {5, 3}, {5, 4}, {4, 4}});
  add(scene, {{8, 0}, {9, 0}, {9, 1}, {8, 1}});
  for (const std::size_t b : {4U, 5U}) scene.blocks[b].initial_velocity_m_per_s = Point(1, 0);
  const Result with = result_of(scene, 0.1);
  EXPECT_GT(with.counts.slept_islands, 0);  // the stack
  EXPECT_NEAR(with.displacement[4][0], 0.1, 1e-9);
  EXPECT_NEAR(with.displacement[4][1], -9.81 * 0.1 * 0.1 / 2, 0.005);
  EXPECT_GT(with.displacement[5][0], 0.05);
  scene.analysis.sleep = false;
  EXPECT_LT(largest_difference(with, result_of(scene, 0.1)), 1e-9);
}

TEST(Skips, IslandsSolvedApartOrTogetherGiveTheSame) {
  auto scene = two_stacks();
  scene.analysis.sleep = false;
  const Result apart = result_of(scene);
  EXPECT_EQ(apart.counts.most_islands, 2);
  scene.analysis.islands = false;
  EXPECT_LT(largest_difference(apart, result_of(scene)), 1e-9);
}

/// Blocks stay in their order, which what looks them up relies on.
TEST(Skips, IslandsJoinedKeepTheOrderOfBlocks) {
  const Island all = join({{.blocks = {0, 3}, .contacts = {1}, .supports = {}, .couples = {{0, 1}}},
                           {.blocks = {1, 2}, .contacts = {0}, .supports = {2}, .couples = {{0, 1}}}});
  EXPECT_THAT(all.blocks, testing::ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(all.couples, testing::ElementsAre(std::pair(0, 3), std::pair(1, 2)));
}

TEST(Skips, SearchesThatFindWhatIsKnownChangeNoBit) {
  auto standing = pyramid(10);
  auto pushed = two_stacks();
  for (scene::Scene* scene : {&standing, &pushed}) {
    scene->analysis.sleep = false;
    const Result with = result_of(*scene, 1);
    scene->analysis.skip_searches = false;
    const Result without = result_of(*scene, 1);
    EXPECT_EQ(without.counts.skipped_searches, 0);
    EXPECT_EQ(with.counts.searches + with.counts.skipped_searches, without.counts.searches);
    EXPECT_EQ(largest_difference(with, without), 0);
    if (scene == &standing) EXPECT_GT(with.counts.skipped_searches, 50);
  }
}

/// Of walls that fall on a tilted ground, in windows of two steps; also in a run that is resumed from a checkpoint
/// between the search and its step.
TEST(Skips, ASearchAheadOfItsStepChangesNoBit) {
  for (const auto integrator :
       {scene::Integrator::shi, scene::Integrator::trapezoidal, scene::Integrator::generalized_alpha}) {
    for (const auto rigid : {scene::Rigid::all, scene::Rigid::none}) {
      auto scene = brick_wall(24);
      scene.analysis.step_s = 0.01;
      scene.analysis.integrator = integrator;
      scene.analysis.rigid = rigid;
      scene.analysis.gravity_tilt_deg = 40;
      Solid plain(scene);
      Solid ahead(scene);
      Solid resumed(scene);
      for (int window = 0; window < 40; ++window) {
        for (Solid* solid : {&plain, &ahead}) solid->advance(0.02 * window, 0.02 * (window + 1), {});
        if (window > 20) resumed.advance(0.02 * window, 0.02 * (window + 1), {});
        ahead.prepare();
        if (window == 20) checkpoint::unpack(checkpoint::pack(ahead), resumed);
      }
      EXPECT_GT(plain.largest_displacement_m(), 0.3);
      for (const Solid* solid : {&ahead, &resumed}) {
        for (std::size_t b = 0; b < plain.states().size(); ++b) {
          ASSERT_EQ(solid->states()[b].displacement, plain.states()[b].displacement) << b;
        }
      }
    }
  }
}

/// Blocks that stand, by Cholesky's factors, and blocks that slide, by LU.
TEST(Skips, FactorsThatServeAgainLeaveTheAnswerAsItIs) {
  for (auto scene : {pyramid(10), rock_slope(60, 0.3)}) {
    scene.analysis.sleep = false;
    const Result with = result_of(scene, 0.2);
    scene.analysis.reuse_factors = false;
    const Result without = result_of(scene, 0.2);
    EXPECT_EQ(without.counts.reused_factorizations, 0);
    EXPECT_GT(with.counts.reused_factorizations, 0);
    EXPECT_EQ(without.counts.factorizations, without.counts.iterations);
    EXPECT_LT(largest_difference(with, without), 1e-8);
  }
}

/// A checkpoint holds what factors were made of: a run that is resumed has the same, and ends with the same bits.
TEST(Skips, FactorsThatOutliveACheckpointServeAResumedRunAsTheyWould) {
  auto scene = brick_wall(60);
  scene.analysis.rigid = scene::Rigid::none;
  scene.analysis.step_s = 1e-3;
  scene.default_joint.cohesion_pa = scene.default_joint.tension_strength_pa = 1e9;
  Solid whole(scene);
  run(whole, 0.01);
  Solid resumed(scene);
  checkpoint::unpack(checkpoint::pack(whole), resumed);
  checkpoint::unpack(checkpoint::pack(resumed), resumed);  // before it has made a step
  const Counts before = whole.counts();
  for (Solid* solid : {&whole, &resumed}) solid->advance(0.01, 0.02, {});
  EXPECT_GT(whole.counts().reused_factorizations, before.reused_factorizations + 10);
  EXPECT_EQ(resumed.counts().factorizations, whole.counts().factorizations);
  for (std::size_t b = 0; b < whole.states().size(); ++b) {
    ASSERT_EQ(resumed.states()[b].displacement, whole.states()[b].displacement) << b;
    ASSERT_EQ(resumed.states()[b].velocity, whole.states()[b].velocity) << b;
  }
}

TEST(Skips, ABlockThatIsReleasedDoesNotSleepHoweverShortTheStep) {
  auto scene = empty_scene();
  scene.analysis.step_s = 1e-6;
  add(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  Solid solid(scene);
  run(solid, 1e-4);
  EXPECT_NEAR(solid.states()[0].displacement[1] / (-9.81 * 1e-8 / 2), 1, 1e-3);
}

std::vector<std::string> rigid_blocks_of(const scene::Scene& scene) {
  const Solid solid(scene);
  std::vector<std::string> names;
  for (const Block& block : solid.blocks()) {
    if (block.rigid) names.push_back(block.name);
  }
  return names;
}

TEST(Skips, AStackIsFoundRigidAndAWallIsNot) {
  using testing::ElementsAre;
  auto scene = two_stacks();
  EXPECT_THAT(rigid_blocks_of(scene), ElementsAre());
  scene.analysis.rigid = scene::Rigid::automatic;
  EXPECT_THAT(rigid_blocks_of(scene), ElementsAre("b1", "b2", "b3", "b4", "b5", "b6", "b7", "b8"));
  add(scene, {{2, 0}, {3, 0}, {3, 1}, {2, 1}});  // touches the left stack's lowest block, and the floor
  EXPECT_THAT(rigid_blocks_of(scene), ElementsAre("b5", "b6", "b7", "b8"));
  const auto without_load = scene;
  scene.point_loads[0].force_x_n_per_m.value.back() = 1e9;  // would strain b8 by millimetres
  EXPECT_THAT(rigid_blocks_of(scene), ElementsAre());
  scene = without_load;
  scene.blocks[6].initial_stress_pa = Eigen::Vector3d(0, -1e5, 0);
  EXPECT_THAT(rigid_blocks_of(scene), ElementsAre());
  scene = without_load;
  scene.materials[0].youngs_modulus_pa = 1e6;  // soft: strain moves points by millimetres
  EXPECT_THAT(rigid_blocks_of(scene), ElementsAre());
}

TEST(Skips, RigidBlocksFailAtTheSameLoadAndSlideAsTheFormulaSaysAtAnyStep) {
  const double weight = 4 * 2500 * 9.81;
  const double strength = weight * std::tan(std::numbers::pi / 6);
  for (const double dt : {1e-2, 1e-3, 1e-4}) {
    for (const double share : {0.999, 1.1}) {
      auto scene = empty_scene();
      scene.analysis.rigid = scene::Rigid::all;
      scene.analysis.step_s = dt;
      add(scene, {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, true);
      add(scene, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
      scene::PointLoad load{.block = 1, .point_m = Point(0, 0.2)};
      load.force_x_n_per_m = scene::TimeTable::constant(share * strength);
      load.force_y_n_per_m = scene::TimeTable::constant(0);
      scene.point_loads.push_back(load);
      const double moved = result_of(scene, 0.2).displacement[1][0];
      const double expected = share < 1 ? 0 : (share - 1) * strength / (4 * 2500) * 0.2 * 0.2 / 2;
      EXPECT_NEAR(moved, expected, 1e-9) << dt << " " << share;
    }
  }
}

}  // namespace
}  // namespace blockweir::solid::skips_test
