// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// The shear strength of rough joints in rock, and the keys that state it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/scene/joint_law.hpp"
#include "bridge/scene/read/read.hpp"
#include "tests/scenes_of_tables.hpp"

namespace blockweir::scene::barton_bandis_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

JointLaw rough(double friction_angle_deg, double roughness, double wall_strength_pa) {
  JointLaw law{.friction_angle_deg = friction_angle_deg};
  law.roughness = roughness;
  law.wall_strength_pa = wall_strength_pa;
  return law;
}

double strength(const JointLaw& law, double normal_pa) {
  const StrengthLine line = law.tangent(law.friction(), normal_pa);
  return line.cohesion_pa + line.friction * normal_pa;
}

TEST(BartonBandis, HasTheAngleOfItsStress) {
  const JointLaw law = rough(30, 10, 50e6);
  EXPECT_NEAR(strength(law, 0.5e6) / (0.5e6 * std::tan(50 * degree)), 1, 1e-14);  // 30 + 10 log10(100)
  EXPECT_NEAR(strength(law, 5e6) / (5e6 * std::tan(40 * degree)), 1, 1e-14);
}

TEST(BartonBandis, ItsLineIsTheTangentOfItsStrengthAndLiesAboveIt) {
  const JointLaw law = rough(28, 12, 80e6);
  for (const double normal_pa : {1e5, 1e6, 2e7, 79e6, 81e6, 2e8}) {
    const double step = 1e-4 * normal_pa;
    const StrengthLine line = law.tangent(law.friction(), normal_pa);
    const double slope = (strength(law, normal_pa + step) - strength(law, normal_pa - step)) / (2 * step);
    EXPECT_NEAR(line.friction / slope, 1, 1e-6) << normal_pa;
    for (const double other_pa : {1.0, 1e4, 1e6, 5e7, 3e8}) {
      EXPECT_GE(line.cohesion_pa + line.friction * other_pa, (1 - 1e-12) * strength(law, other_pa)) << normal_pa;
    }
  }
}

TEST(BartonBandis, IsNoSteeperThanSeventyDegrees) {
  const JointLaw law = rough(30, 15, 100e6);
  EXPECT_DOUBLE_EQ(strength(law, 100), 100 * std::tan(70 * degree));
  EXPECT_EQ(law.tangent(law.friction(), 0).cohesion_pa, 0);
}

TEST(BartonBandis, StrengthReductionDividesAllOfIt) {
  JointLaw law = rough(30, 10, 50e6);
  const double before = strength(law, 1e6);
  law.reduce(2);
  EXPECT_DOUBLE_EQ(strength(law, 1e6), before / 2);
}

TEST(BartonBandis, APlaneJointIsMohrCoulombs) {
  const JointLaw law = rough(35, 0, 0);
  EXPECT_FALSE(law.bends());
  EXPECT_EQ(law.tangent(law.friction(), 1e6).friction, law.friction());
  EXPECT_EQ(law.tangent(law.friction(), 1e6).cohesion_pa, 0);
}

std::string refusal_of(const std::string& keys) {
  std::string text = test::scene_with("joint");
  text.replace(text.find("[joint]\n"), 8, "[joint]\n" + keys);
  try {
    read_text(text, "scene.toml");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(BartonBandis, RoughnessAndTheStrengthOfItsWallsNeedEachOther) {
  EXPECT_THAT(refusal_of("roughness = 8\n"), testing::HasSubstr("the joint has no wall strength"));
  EXPECT_THAT(refusal_of("wall_strength_pa = 50e6\n"), testing::HasSubstr("the joint has no roughness"));
  EXPECT_EQ(refusal_of("roughness = 8\nwall_strength_pa = 50e6\n"), "");
}

}  // namespace
}  // namespace blockweir::scene::barton_bandis_test
