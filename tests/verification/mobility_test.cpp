// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// Which blocks contacts leave a rigid motion, and on which surfaces a structure could part.
#include "solid/watch/mobility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solid/watch/failure_watch.hpp"
#include "solid/watch/surfaces.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::mobility_test {
namespace {

void add_box(scene::Scene& scene, double x, double y, double width, double height, bool fixed = false) {
  add(scene, {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, fixed);
}

/// Ground, a base of 4 m and two columns of two boxes on it.
scene::Scene frame(double friction_angle_deg) {
  auto scene = empty_scene();
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = friction_angle_deg;
  add_box(scene, -5, -1, 10, 1, true);
  add_box(scene, -2, 0, 4, 1);
  for (const double x : {-2.0, 1.0}) {
    add_box(scene, x, 1, 1, 1);
    add_box(scene, x, 2, 1, 1);
  }
  return scene;
}

TEST(Mobility, WhatSticksOnlyStrainsHoweverManyBlocksAreOnEachOther) {
  const auto scene = frame(30);
  Solid solid(scene);
  solid.settle({});
  const std::vector<bool> moves = {false, true, true, true, true, true};
  EXPECT_EQ(mobility(solid, moves).only_strains, moves);
}

/// A push at the height of the upper box's middle, times its weight: it slides beyond tan(friction), the column turns
/// beyond 2/3.
TEST(Mobility, WhatSlidesOrTurnsHasAMotionOfItsOwnAndSoHasWhatItCarries) {
  for (const auto& [friction_angle_deg, push] : {std::pair{20.0, 0.45}, std::pair{60.0, 0.75}}) {
    auto scene = frame(friction_angle_deg);
    scene::PointLoad load{.block = 3, .point_m = Point(-2, 2.5)};
    load.force_x_n_per_m = scene::TimeTable::constant(push * 2500 * 9.81);
    load.force_y_n_per_m = scene::TimeTable::constant(0);
    scene.point_loads.push_back(load);
    Solid solid(scene);
    solid.settle({});
    run(solid, 0.05);
    const std::vector<bool> held = mobility(solid, {false, true, true, true, true, true}).only_strains;
    EXPECT_TRUE(held[1]);
    EXPECT_EQ(held[2], push < 2.0 / 3);
    EXPECT_FALSE(held[3]);
    EXPECT_TRUE(held[4] && held[5]);
  }
}

/// Nothing holds it, nothing pushes it.
TEST(Mobility, WithoutGravityWhatLiesStillIsNotMoving) {
  auto scene = empty_scene();
  scene.analysis.gravity_m_per_s2 = 0;
  add_box(scene, 0, 0, 1, 1);
  for (const double speed_m_per_s : {0.0, 0.1}) {
    scene.blocks[0].initial_velocity_m_per_s = {speed_m_per_s, 0};
    Solid solid(scene);
    FailureWatch watch(solid);
    watch.look(0, {});
    run(solid, 0.05);
    watch.look(0.05, {});
    EXPECT_EQ(watch.moving().has_value(), speed_m_per_s > 0);
  }
}

TEST(Mobility, BlocksThatHoldEachOtherAcrossAGapAreHeldTogether) {
  // A three-hinged frame: two leaning boxes touch in points at the feet and at the top.
  auto scene = empty_scene();
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 45;
  add_box(scene, -9, -1, 18, 1, true);
  add(scene, {{-2, 0}, {-1.6, 0.1}, {0, 3.8}, {0, 4}});
  add(scene, {{2, 0}, {0, 4}, {0, 3.8}, {1.6, 0.1}});
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.05);
  const std::vector<bool> held = mobility(solid, {false, true, true}).only_strains;
  EXPECT_TRUE(held[1]);
  EXPECT_TRUE(held[2]);
}

/// Its toe has two contacts with the corner of the ground, as far apart as springs let it in.
TEST(Mobility, WhatTurnsOnACornerIsNotHeldByTheTwoContactsThere) {
  auto scene = empty_scene();
  scene.contact.formulation = scene::ContactFormulation::penalty;
  scene.contact.stiffness_n_per_m2 = 1e8;  // half a millimetre of settlement
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 60;
  scene.analysis.rigid = scene::Rigid::all;
  add(scene, {{-5, -1}, {5, -1}, {5, 0.1}, {1, 0.1}, {0, 0}, {-5, 0}}, true);
  add(scene, {{0, 0}, {1, 0.1}, {1, 2}, {0, 2}});
  scene::PointLoad load{.block = 1, .point_m = Point(0, 2)};
  load.force_x_n_per_m = scene::TimeTable::constant(0.4 * 2 * 2500 * 9.81);
  load.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads.push_back(load);
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.3);
  ASSERT_LT(solid.states()[1].displacement[2], -0.01);
  EXPECT_FALSE(mobility(solid, {false, true}).only_strains[1]);
}

TEST(Surfaces, OfAWallAreItsBedJointsAndNoneOfItsHeadJoints) {
  auto scene = empty_scene();
  add_box(scene, -1, -1, 6, 1, true);
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3; ++i) add_box(scene, i + (row % 2) * 0.5, row * 0.5, 1, 0.5);
  }
  Solid solid(scene);
  const Surfaces surfaces(solid);
  std::vector<std::string> long_names;
  for (const std::string& name : surfaces.names()) {
    if (name.find("in one line") != std::string::npos) long_names.push_back(name);
  }
  EXPECT_EQ(long_names.size(), 3U);
  EXPECT_TRUE(surfaces.of({1, 2}).empty());  // upright, between two bricks of a row
}

TEST(Surfaces, AreThoseOfTheOutlineWhereAJointHasOpened) {
  auto scene = empty_scene();
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 80;
  add_box(scene, -5, -1, 10, 1, true);
  for (const double x : {0.0, 1.0}) add_box(scene, x, 0, 1, 4);
  scene::PointLoad load{.block = 1, .point_m = Point(0, 4)};  // more than one box bears, less than both
  load.force_x_n_per_m = scene::TimeTable::constant(0.35 * 4 * 2500 * 9.81);
  load.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads.push_back(load);
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.1);
  const auto opened = [](const ContactPoint& c) {
    return c.pair() == std::pair{0, 1} && c.state == ContactState::open && c.gap > 1e-9;
  };
  ASSERT_TRUE(std::any_of(solid.contacts().begin(), solid.contacts().end(), opened));
  const Surfaces surfaces(solid);
  EXPECT_FALSE(surfaces.of({0, 1}).empty());
  EXPECT_EQ(surfaces.of({0, 1}), surfaces.of({0, 2}));
}

TEST(Surfaces, OfATowerAreAllItsJoints) {
  const auto scene = frame(30);
  Solid solid(scene);
  const Surfaces surfaces(solid);
  for (const auto& pair : {std::pair{0, 1}, {1, 2}, {2, 3}, {1, 4}, {4, 5}}) EXPECT_FALSE(surfaces.of(pair).empty());
}

}  // namespace
}  // namespace blockweir::solid::mobility_test
