// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// The sliding factor and the resultant of a structure that stands, where its ground is no plane.
#include "solid/watch/margins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::margins_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A dam on ground of this outline, under gravity that is tilted downstream by 25 degrees.
scene::Scene dam_on(const std::vector<Point>& ground, const Point& toe) {
  auto scene = empty_scene();
  add(scene, ground, true);
  add(scene, {{0, 0}, toe, {4, 14}, {0, 14}});
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 40;
  scene.analysis.gravity_tilt_deg = 25;
  scene.analysis.rigid = scene::Rigid::all;
  return scene;
}

Margins margins_of(const scene::Scene& scene) {
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.05);
  Margins margins;
  margins.look(solid, 0.05, Levels{0});
  return margins;
}

/// The heel lies in the corner between level ground and its base: some of what it bears presses on the level ground.
TEST(Margins, CountForcesAlongTheBaseWhereItsEndsMeetOtherFaces) {
  for (const double rise : {0.5, 1.0, 2.0}) {
    const auto scene = dam_on({{-20, -5}, {30, -5}, {30, 3 * rise}, {0, 0}, {-20, 0}}, {10, rise});
    const Margins margins = margins_of(scene);
    ASSERT_TRUE(margins.sliding()) << rise;
    const double dip = std::atan(rise / 10);
    const double factor = std::tan(40 * degree) / std::tan(25 * degree - dip);
    EXPECT_NEAR(margins.sliding()->value / factor, 1, 1e-6) << rise;
  }
}

/// Two legs apart and a beam on both, which parts stand in one line; with the beam in two, half on each leg.
TEST(Margins, ALineWithAGapThatNoBlockSpansIsNoSurface) {
  for (const bool spanned : {true, false}) {
    auto scene = empty_scene();
    add(scene, {{-5, -5}, {15, -5}, {15, 0}, {-5, 0}}, true);
    add(scene, {{0, 0}, {1, 0}, {1, 4}, {0, 4}});
    add(scene, {{9, 0}, {10, 0}, {10, 4}, {9, 4}});
    if (spanned) {
      add(scene, {{0, 4}, {10, 4}, {10, 5}, {0, 5}});
    } else {
      add(scene, {{0, 4}, {1, 4}, {5, 4.5}, {5, 5}, {0, 5}});
      add(scene, {{9, 4}, {10, 4}, {10, 5}, {5, 5}, {5, 4.5}});
    }
    Solid solid(scene);
    const std::vector<std::string> names = Surfaces(solid).names();
    const auto in_line = [](const std::string& name) { return name.find("in one line") != std::string::npos; };
    EXPECT_EQ(std::count_if(names.begin(), names.end(), in_line), spanned ? 1 : 0);
  }
}

TEST(Margins, TellTheEndThatTheResultantIsNearestTo) {
  for (const double tilt_deg : {-10.0, 10.0}) {
    auto scene = dam_on({{-20, -5}, {30, -5}, {30, 0}, {-20, 0}}, {4, 0});
    scene.analysis.gravity_tilt_deg = tilt_deg;
    const Margins margins = margins_of(scene);
    ASSERT_TRUE(margins.overturning());
    EXPECT_EQ(margins.overturning()->end, tilt_deg > 0 ? "downstream" : "upstream");
  }
}

/// Level ground before the toe of a base that dips downstream resists: the base alone would have 0.9 and less.
TEST(Margins, TellNoFactorOfABaseThatTheGroundBeforeItsToeHolds) {
  for (const double fall : {1.0, 2.0}) {
    auto scene = dam_on({{-20, -10}, {30, -10}, {30, -fall}, {10, -fall}, {0, 0}, {-20, 0}}, {10, -fall});
    scene.analysis.gravity_tilt_deg = 37;
    const Margins margins = margins_of(scene);
    EXPECT_TRUE(margins.any_surface());
    EXPECT_TRUE(margins.buttressed()) << fall;
    EXPECT_FALSE(margins.sliding()) << fall << ": " << margins.sliding()->value;
  }
}

TEST(Margins, TellNoFactorOfABaseWithItsToeInTheGround) {
  const auto scene = dam_on({{-20, -5}, {30, -5}, {30, 2}, {10, 2}, {10, 0}, {-20, 0}}, {10, 0});
  auto keyed = scene;
  keyed.blocks[1].vertices = {{0, 0}, {10, 0}, {10, 3}, {4, 14}, {0, 14}};
  EXPECT_FALSE(margins_of(keyed).any_surface());
  EXPECT_EQ(bent_joints(Solid(keyed)).size(), 1U);  // a line says that it has no row
  EXPECT_TRUE(bent_joints(Solid(dam_on({{-20, -5}, {30, -5}, {30, 0}, {-20, 0}}, {10, 0}))).empty());
}

/// A broad dam, and a slender one beside it on the same level ground, whose resultant is the nearer to an end.
TEST(Margins, AreToldOfEachStructureApart) {
  auto scene = empty_scene();
  add(scene, {{-20, -5}, {80, -5}, {80, 0}, {-20, 0}}, true);
  add(scene, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  add(scene, {{40, 0}, {44, 0}, {44, 8}, {40, 8}});
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 40;
  scene.analysis.gravity_tilt_deg = 10;
  scene.analysis.rigid = scene::Rigid::all;
  const Margins margins = margins_of(scene);
  ASSERT_TRUE(margins.overturning());
  EXPECT_NEAR(margins.overturning()->value, 0.5 - std::tan(10 * degree), 1e-6);
  EXPECT_EQ(margins.overturning()->joint.find("in one line"), std::string::npos) << margins.overturning()->joint;
}

/// What stands side by side and touches is one structure on one base.
TEST(Margins, AreToldOfALineWhereBlocksTouchEachOther) {
  auto scene = empty_scene();
  add(scene, {{-20, -5}, {80, -5}, {80, 0}, {-20, 0}}, true);
  add(scene, {{0, 0}, {5, 0}, {5, 10}, {0, 10}});
  add(scene, {{5, 0}, {10, 0}, {10, 10}, {5, 10}});
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 40;
  scene.analysis.gravity_tilt_deg = 10;
  scene.analysis.rigid = scene::Rigid::all;
  const Margins margins = margins_of(scene);
  ASSERT_TRUE(margins.sliding());
  EXPECT_NE(margins.sliding()->joint.find("in one line"), std::string::npos) << margins.sliding()->joint;
}

/// Rock that touches the dam in the one point under its heel.
TEST(Margins, AreToldWhereACornerOfTheRockTouchesTheHeel) {
  auto scene = empty_scene();
  add(scene, {{-20, -5}, {0, -5}, {0, 0}, {-20, 0}}, true);
  add(scene, {{0, -5}, {30, -5}, {30, 0}, {0, 0}}, true);
  add(scene, {{0, 0}, {10, 0}, {4, 14}, {0, 14}});
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 40;
  scene.analysis.gravity_tilt_deg = 20;
  scene.analysis.rigid = scene::Rigid::all;
  const Margins margins = margins_of(scene);
  ASSERT_TRUE(margins.sliding());
  EXPECT_NEAR(margins.sliding()->value, std::tan(40 * degree) / std::tan(20 * degree), 1e-6);
}

}  // namespace
}  // namespace blockweir::solid::margins_test
