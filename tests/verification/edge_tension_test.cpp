// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// A brittle bond that its tension holds: what blocks without a mesh bear beyond the strength at the joint's edge.
#include "solid/watch/edge_tension.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid {
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
  EXPECT_NEAR(tension.ratio(), 0.9, 1e-6);
  EXPECT_EQ(tension.warning(), "");
}

/// The bond holds: its tension acts at both ends.
TEST(EdgeTension, IsWarnedOfBeyondTheStrength) {
  const EdgeTension tension = looked_at(cantilever(2));
  EXPECT_NEAR(tension.ratio(), 2, 1e-6);
  EXPECT_THAT(tension.warning(), testing::AllOf(testing::HasSubstr("joint \"b0 on b1\" holds by its tension"),
                                                testing::HasSubstr("2e+06 Pa at its edge"),
                                                testing::HasSubstr("give both blocks a mesh_size_m")));
}

TEST(EdgeTension, OfABondThatSoftensIsNone) {
  auto scene = cantilever(2);
  scene.default_joint.softening_slip_m = 0.01;
  EXPECT_EQ(looked_at(scene).ratio(), 0);
}

}  // namespace
}  // namespace blockweir::solid
