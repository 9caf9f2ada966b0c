// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Bolts against closed answers: elongation, limit of an anchored block, yield, slack.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solid/step/solid.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::bolts_test {
namespace {

constexpr double weight = 2500 * 9.81;  // of the block, 1 m2

scene::Scene hanging(const scene::Bolt& bolt) {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.blocks.push_back({.name = "block", .vertices = {{-0.5, 0}, {0.5, 0}, {0.5, 1}, {-0.5, 1}}});
  scene.bolts.push_back(bolt);
  return scene;
}

scene::Bolt hanger() {
  return {.name = "bolt", .blocks = {0, -1}, .from_m = Point(0, 1), .to_m = Point(0, 3), .stiffness_n_per_m2 = 1e7};
}

TEST(Bolts, ABlockHangsByItsWeightOverTheStiffness) {
  const auto scene = hanging(hanger());
  Solid solid(scene);
  solid.settle({});
  EXPECT_NEAR(solid.bolts()[0].elongation_m, weight / 1e7, 1e-10);
  EXPECT_NEAR(solid.bolts()[0].acting.tension_n_per_m, weight, 1e-3);
  run(solid, 0.5);
  EXPECT_NEAR(solid.bolts()[0].elongation_m, weight / 1e7, 1e-9);
}

TEST(Bolts, APrestressOfTheWeightHoldsItInPlace) {
  auto bolt = hanger();
  bolt.prestress_n_per_m = weight;
  const auto scene = hanging(bolt);
  Solid solid(scene);
  solid.settle({});
  EXPECT_NEAR(solid.bolts()[0].elongation_m, 0, 1e-10);
}

TEST(Bolts, YieldLetsTheBlockFallWithWhatIsLeftOfItsWeight) {
  for (const auto& [yield, falls] : {std::pair{1.01 * weight, false}, std::pair{0.9 * weight, true}}) {
    auto bolt = hanger();
    bolt.yield_n_per_m = yield;
    auto scene = hanging(bolt);
    scene.analysis.start = scene::Start::unstressed;
    scene.analysis.mass_damping_per_s = falls ? 0 : 200;
    scene.analysis.step_s = 1e-3;
    Solid solid(scene);
    run(solid, 0.5);
    if (!falls) {
      EXPECT_NEAR(solid.bolts()[0].elongation_m, weight / 1e7, 1e-6);
      EXPECT_EQ(solid.bolts()[0].plastic_m, 0);
    } else {
      // Swings until cos(omega t) = 0.1, then goes on under a tenth of its weight.
      const double omega = std::sqrt(1e7 / 2500);
      const double rest = 0.5 - std::acos(0.1) / omega;
      const double speed = 9.81 / omega * std::sqrt(1 - 0.01);
      EXPECT_NEAR(solid.bolts()[0].elongation_m, yield / 1e7 + speed * rest + 0.981 * rest * rest / 2, 2e-3);
      EXPECT_NEAR(solid.bolts()[0].plastic_m, solid.bolts()[0].elongation_m - yield / 1e7, 1e-9);
      EXPECT_EQ(solid.bolts()[0].acting.state, BoltState::yielding);
    }
  }
}

TEST(Bolts, AnUnloadedBoltIsElasticThenSlack) {
  const scene::Bolt described{
      .blocks = {-1, -1}, .stiffness_n_per_m2 = 1e6, .prestress_n_per_m = 10, .yield_n_per_m = 100};
  Bolt bolt{.described = &described};
  EXPECT_EQ(bolt_force(bolt, 0).tension_n_per_m, 10);
  EXPECT_EQ(bolt_force(bolt, 50e-6).tension_n_per_m, 60);
  EXPECT_EQ(bolt_force(bolt, 1).tension_n_per_m, 100);
  EXPECT_EQ(bolt_force(bolt, 1).slope_n_per_m2, 0);
  EXPECT_EQ(bolt_force(bolt, -20e-6).state, BoltState::slack);
  bolt.plastic_m = 0.5;
  EXPECT_NEAR(bolt_force(bolt, 0.5).tension_n_per_m, 10, 1e-9);
  scene::Bolt strut = described;
  strut.takes_compression = true;
  bolt.described = &strut;
  EXPECT_NEAR(bolt_force(bolt, 0.5 - 40e-6).tension_n_per_m, -30, 1e-6);
  EXPECT_EQ(bolt_force(bolt, 0).tension_n_per_m, -100);
}

/// A block on a plane of 30 degrees with 20 degrees of friction, anchored square to the plane by a prestressed bolt.
bool slides(double prestress, scene::ContactFormulation formulation) {
  const double a = std::numbers::pi / 6;
  const Point t(std::cos(a), -std::sin(a));
  const Point n(std::sin(a), std::cos(a));
  const auto at = [&](double s, double h) -> Point { return s * t + h * n; };
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 20;
  scene.contact.formulation = formulation;
  scene.blocks.push_back({.name = "plane", .vertices = {at(-2, -1), at(4, -1), at(4, 0), at(-2, 0)}, .fixed = true});
  scene.blocks.push_back({.name = "block", .vertices = {at(0, 0), at(2, 0), at(2, 0.5), at(0, 0.5)}});
  scene.bolts.push_back({.name = "anchor",
                         .blocks = {1, 0},
                         .from_m = at(1, 0.5),
                         .to_m = at(1, -0.9),
                         .stiffness_n_per_m2 = 1e4,  // soft: the force stays, whatever the block moves
                         .prestress_n_per_m = prestress});
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.5);
  return solid.states()[1].velocity.head<2>().norm() > 1e-3;
}

TEST(Bolts, AnAnchorHoldsABlockOnAnInclineFromTheForceOfTheFormulaOn) {
  // W sin a = (W cos a + P) tan(phi)
  const double a = std::numbers::pi / 6;
  const double needed = weight * (std::sin(a) / std::tan(std::numbers::pi / 9) - std::cos(a));
  for (const auto formulation : {scene::ContactFormulation::augmented_lagrangian, scene::ContactFormulation::penalty,
                                 scene::ContactFormulation::lagrange_multiplier}) {
    EXPECT_TRUE(slides(0.99 * needed, formulation));
    EXPECT_FALSE(slides(1.01 * needed, formulation));
  }
}

/// Held along a plane of 30 degrees with 20 degrees of friction by a bolt that must stretch by a hundredth of the
/// block.
TEST(Bolts, ASoftBoltIsInEquilibriumFromTheStart) {
  const double a = std::numbers::pi / 6;
  const Point t(std::cos(a), -std::sin(a));
  const Point n(std::sin(a), std::cos(a));
  const auto at = [&](double s, double h) -> Point { return s * t + h * n; };
  const double needed = weight * (std::sin(a) - std::cos(a) * std::tan(std::numbers::pi / 9));
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 20;
  scene.blocks.push_back({.name = "plane", .vertices = {at(-2, -1), at(4, -1), at(4, 0), at(-2, 0)}, .fixed = true});
  scene.blocks.push_back({.name = "block", .vertices = {at(0, 0), at(2, 0), at(2, 0.5), at(0, 0.5)}});
  scene.bolts.push_back({.name = "anchor",
                         .blocks = {1, -1},
                         .from_m = at(0, 0.1),
                         .to_m = at(-1, 0.1),
                         .stiffness_n_per_m2 = needed / 0.01});
  Solid solid(scene);
  solid.settle({});
  EXPECT_TRUE(solid.starts_at_rest());
  EXPECT_NEAR(solid.bolts()[0].acting.tension_n_per_m, needed, 1e-6 * needed);
}

TEST(Bolts, ABoltBetweenTwoBlocksPullsBoth) {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.max_displacement_ratio = 0.05;
  scene.blocks.push_back({.name = "a", .vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  scene.blocks.push_back({.name = "b", .vertices = {{3, 0}, {5, 0}, {5, 1}, {3, 1}}});
  scene.bolts.push_back({.name = "tie",
                         .blocks = {0, 1},
                         .from_m = Point(1, 0.5),
                         .to_m = Point(3, 0.5),
                         .stiffness_n_per_m2 = 1e3,
                         .prestress_n_per_m = 2500});
  Solid solid(scene);
  run(solid, 0.2);
  // 2500 N on 2500 and on 5000 kg.
  EXPECT_NEAR(solid.states()[0].displacement[0], 0.02, 1e-3);
  EXPECT_NEAR(solid.states()[1].displacement[0], -0.01, 1e-3);
  EXPECT_NEAR(2500 * solid.states()[0].velocity[0] + 5000 * solid.states()[1].velocity[0], 0, 1e-6);
}

}  // namespace
}  // namespace blockweir::solid::bolts_test
