// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// A bond that its tension holds, and cohesion of what is in tension: what blocks without a mesh bear beyond the
// strength at the joint's edge.
#include "solid/watch/edge_tension.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::edge_tension_test {
namespace {

constexpr double strength_pa = 1e6;

/// A weightless cantilever of 2 m on its base of 1 m, with a push at its top that bends the bond to `bent` of its
/// strength: the stress at the edge is 6 M/b^2.
scene::Scene cantilever(double bent) {
  auto scene = empty_scene();
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.rigid = scene::Rigid::all;
  scene.default_joint.tension_strength_pa = strength_pa;
  scene.default_joint.cohesion_pa = 10 * strength_pa;
  add(scene, {{-2, -1}, {3, -1}, {3, 0}, {-2, 0}}, true);
  add(scene, {{0, 0}, {1, 0}, {1, 2}, {0, 2}});
  scene::PointLoad load{.block = 1, .point_m = Point(0, 2)};
  load.force_x_n_per_m = scene::TimeTable::constant(bent * strength_pa / 6 / 2);
  load.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads.push_back(load);
  return scene;
}

EdgeTension looked_at(const scene::Scene& scene) {
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.02);
  EdgeTension tension;
  tension.look(solid, 0.02, 0);
  return tension;
}

TEST(EdgeTension, IsTheStressOfABeamAtItsEdge) {
  const EdgeTension tension = looked_at(cantilever(0.9));
  EXPECT_NEAR(tension.stress_pa() / strength_pa, 0.9, 1e-6);
  EXPECT_EQ(tension.warning(), "");
}

/// The bond holds: its tension acts at both ends.
TEST(EdgeTension, IsWarnedOfBeyondTheStrength) {
  const EdgeTension tension = looked_at(cantilever(2));
  EXPECT_NEAR(tension.stress_pa() / strength_pa, 2, 1e-6);
  EXPECT_THAT(tension.warning(), testing::AllOf(testing::HasSubstr("joint \"b1 on b0\" holds by its tension"),
                                                testing::HasSubstr("2e+06 Pa at its edge"),
                                                testing::HasSubstr("give block \"b1\" a mesh_size_m")));
}

TEST(EdgeTension, OfABondThatSoftensIsNone) {
  auto scene = cantilever(2);
  scene.default_joint.softening_slip_m = 0.01;
  EXPECT_EQ(looked_at(scene).stress_pa(), 0);
}

constexpr double cohesion_pa = 5e4;
constexpr double press_n_per_m = 1e5;

/// The same with cohesion alone, pressed so that the resultant meets the base of 1 m at `end_distance_m` from its end.
scene::Scene pressed_cantilever(double end_distance_m) {
  auto scene = cantilever(0);
  scene.default_joint.tension_strength_pa = 0;
  scene.default_joint.cohesion_pa = cohesion_pa;
  scene.point_loads.clear();
  scene::PointLoad load{.block = 1, .point_m = Point(0.5, 2)};
  load.force_x_n_per_m = scene::TimeTable::constant(press_n_per_m * (0.5 - end_distance_m) / 2);
  load.force_y_n_per_m = scene::TimeTable::constant(-press_n_per_m);
  scene.point_loads.push_back(load);
  return scene;
}

TEST(EdgeTension, CohesionOfAJointThatIsAllPressedIsNoTrouble) {
  const EdgeTension tension = looked_at(pressed_cantilever(0.34));
  EXPECT_EQ(tension.cracked(), 0);
  EXPECT_EQ(tension.warning(), "");
}

/// Without tension strength three times the way of the resultant from its end is pressed.
TEST(EdgeTension, CohesionOutsideTheMiddleThirdIsWarnedOf) {
  const EdgeTension tension = looked_at(pressed_cantilever(0.1));
  EXPECT_NEAR(tension.cracked(), 0.7, 1e-6);
  const double strength = 0.3 * cohesion_pa + press_n_per_m * std::tan(std::numbers::pi / 6);
  EXPECT_NEAR(tension.cracked_factor(), strength / (press_n_per_m * 0.4 / 2), 1e-6);
  EXPECT_THAT(tension.warning(),
              testing::AllOf(testing::HasSubstr(
                                 "joint \"b1 on b0\" has no tension_strength_pa, and its cohesion acts over the whole"),
                             testing::HasSubstr("70 % of the joint is in tension"),
                             testing::HasSubstr("give block \"b1\" a mesh_size_m")));
}

/// A crack runs on until the stress at its tip is the strength: 1e5 l^2 - 2 N l + 6 N d = 0 with N = 1e5, d = 0.1.
TEST(EdgeTension, ACrackEndsWhereTheStrengthHolds) {
  auto scene = pressed_cantilever(0.1);
  scene.default_joint.tension_strength_pa = press_n_per_m;
  scene.default_joint.cohesion_pa = press_n_per_m;  // a strength beyond c/tan(phi) would count as that
  EXPECT_NEAR(looked_at(scene).cracked(), std::sqrt(1 - 0.6), 1e-6);
}

TEST(EdgeTension, CohesionThatACrackDoesNotTakeIsNone) {
  auto scene = pressed_cantilever(0.1);
  scene.default_joint.keeps_cohesion = true;
  EXPECT_EQ(looked_at(scene).warning(), "");
}

}  // namespace
}  // namespace blockweir::solid::edge_tension_test
