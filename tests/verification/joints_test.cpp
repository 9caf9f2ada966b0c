// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Laws of joints against closed answers: dilation, softening, tension; the same for all three contact formulations.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::joints_test {
namespace {

constexpr double pi = std::numbers::pi;
const double weight = 4 * 2500 * 9.81;

class Joints : public testing::TestWithParam<scene::ContactFormulation> {
 protected:
  /// A block of 4 m by 1 m on the ground, its lower corner led along x by 0.1 mm a step.
  /// A step is long: what inertia a quasi-static one has, 2 M d/dt^2, is 4e-6 of the weight.
  static scene::Scene led_block() {
    auto scene = empty_scene();
    scene.contact.formulation = GetParam();
    scene.analysis.kind = scene::AnalysisKind::quasi_static;
    scene.analysis.step_s = 1;
    scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 30;
    add(scene, {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, true);
    add(scene, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
    scene::Support support{.block = 1, .point_m = Point(0, 0)};
    support.displacement_x_m = scene::TimeTable{.time_s = {0, 1000}, .value = {0, 0.1}};
    scene.supports.push_back(support);
    return scene;
  }

  static double shear(const Solid& solid) {
    double sum = 0;
    for (const ContactPoint& c : solid.contacts()) {
      if (c.state != ContactState::open) sum += c.force.y();
    }
    return std::abs(sum);
  }
};

std::string name_of(const testing::TestParamInfo<scene::ContactFormulation>& tested) {
  if (tested.param == scene::ContactFormulation::penalty) return "Penalty";
  return tested.param == scene::ContactFormulation::lagrange_multiplier ? "LagrangeMultiplier" : "AugmentedLagrangian";
}

INSTANTIATE_TEST_SUITE_P(Formulation, Joints,
                         testing::Values(scene::ContactFormulation::augmented_lagrangian,
                                         scene::ContactFormulation::lagrange_multiplier,
                                         scene::ContactFormulation::penalty),
                         name_of);

TEST_P(Joints, ADilatingJointOpensByTheTangentOfItsAngleUpToItsLimit) {
  auto scene = led_block();
  scene.default_joint.dilation_angle_deg = 10;
  scene.default_joint.dilation_limit_m = 0.06;
  Solid solid(scene);
  solid.settle({});
  const double height = solid.placements()[1].centre().y();
  const double start = solid.placements()[1].centre().x();
  for (int n = 0; n < 1000; ++n) {
    solid.advance(n, n + 1, {});
    if (n % 100 != 99) continue;
    const double slip = solid.placements()[1].centre().x() - start;
    EXPECT_NEAR(solid.placements()[1].centre().y() - height, std::tan(10 * pi / 180) * std::min(slip, 0.06), 2e-6)
        << slip;
    EXPECT_NEAR(shear(solid) / (weight * std::tan(30 * pi / 180)), 1, 1e-5) << slip;
  }
}

/// At steps so short that inertia would hold it back, and at rest it would spring back.
TEST_P(Joints, ALedBlockBearsItsFrictionAtShortQuasiStaticSteps) {
  auto scene = led_block();
  scene.analysis.step_s = 0.01;
  scene.supports[0].displacement_x_m = scene::TimeTable{.time_s = {0, 1}, .value = {0, 0.01}};
  // Multipliers share what is redundant by a compliance of theirs.
  const double tolerance = GetParam() == scene::ContactFormulation::lagrange_multiplier ? 5e-3 : 1e-3;
  Solid solid(scene);
  solid.settle({});
  for (int n = 0; n < 60; ++n) {
    solid.advance(n * 0.01, (n + 1) * 0.01, {});
    if (n % 20 == 19) EXPECT_NEAR(shear(solid) / (weight * std::tan(30 * pi / 180)), 1, tolerance) << n;
  }
}

TEST_P(Joints, ASofteningJointLosesCohesionAndPeakFrictionLinearlyWithItsSlip) {
  auto scene = led_block();
  scene.default_joint.residual_friction_angle_deg = 20;
  scene.default_joint.cohesion_pa = 50e3;
  scene.default_joint.softening_slip_m = 0.05;
  Solid solid(scene);
  solid.settle({});
  double peak = 0;
  const double peak_strength = weight * std::tan(30 * pi / 180) + 50e3 * 4;
  const double residual_strength = weight * std::tan(20 * pi / 180);
  for (int n = 0; n < 1000; ++n) {
    solid.advance(n, n + 1, {});
    peak = std::max(peak, shear(solid));
    double slip = 0;
    for (const ContactPoint& c : solid.contacts()) slip = std::max(slip, c.slip_path_m);
    if (n % 100 != 99) continue;
    // The strength of a step is that of the slip before it: 1e-4 m less.
    const double left = std::max(0.0, 1 - slip / 0.05);
    const double expected = residual_strength + left * (peak_strength - residual_strength);
    EXPECT_NEAR(shear(solid), expected, 3e-3 * peak_strength) << slip;
  }
  EXPECT_NEAR(peak / peak_strength, 1, 3e-3);
}

/// 1 m by 0.5 m, led at a corner of the joint, whose contacts then share their shear with the support in any way, or by
/// its head.
TEST_P(Joints, ARigidBlockThatIsDraggedBearsWhatItsSofteningJointHasLeft) {
  for (const Point& led_m : {Point(1, 0), Point(0, 0.5)}) {
    auto scene = led_block();
    scene.blocks.pop_back();
    add(scene, {{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}});
    scene.analysis.rigid = scene::Rigid::all;
    scene.analysis.step_s = 0.01;
    scene.supports[0].point_m = led_m;
    scene.supports[0].displacement_x_m = scene::TimeTable{.time_s = {0, 1}, .value = {0, 0.1}};
    scene.default_joint.residual_friction_angle_deg = 20;
    scene.default_joint.cohesion_pa = 1e3;
    scene.default_joint.softening_slip_m = 0.05;
    Solid solid(scene);
    solid.settle({});
    const double peak = weight / 8 * std::tan(30 * pi / 180) + 1e3;
    const double residual = weight / 8 * std::tan(20 * pi / 180);
    for (int n = 0; n < 100; ++n) {
      solid.advance(n * 0.01, (n + 1) * 0.01, {});
      const double left = std::max(0.0, 1 - (n + 1) * 1e-3 / 0.05);
      ASSERT_NEAR(shear(solid) / peak, (residual + left * (peak - residual)) / peak, 1e-6) << led_m.y() << " m, " << n;
    }
  }
}

TEST_P(Joints, ATensionStrengthHoldsAHangingBlockUpToItsValue) {
  for (const auto& [share, holds] : {std::pair{1.01, true}, std::pair{0.99, false}}) {
    auto scene = empty_scene();
    scene.contact.formulation = GetParam();
    scene.default_joint.tension_strength_pa = share * weight / 4;
    scene.default_joint.cohesion_pa = weight;  // else Mohr-Coulomb leaves nothing for shear under tension
    add(scene, {{-9, 1}, {9, 1}, {9, 2}, {-9, 2}}, true);
    add(scene, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
    Solid solid(scene);
    solid.settle({});
    run(solid, 0.5);
    EXPECT_EQ(solid.states()[1].displacement[1] > -1e-3, holds) << share;
  }
}

TEST_P(Joints, ABlockSlidesDownAnInclineAsTheFormulaSays) {
  auto scene = empty_scene();
  scene.contact.formulation = GetParam();
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 20;
  scene.analysis.max_displacement_ratio = 0.5;
  const auto turned = [](double x, double y) {
    return Point(x * std::cos(pi / 6) + y * std::sin(pi / 6), -x * std::sin(pi / 6) + y * std::cos(pi / 6));
  };
  add(scene, {turned(-2, -1), turned(12, -1), turned(12, 0), turned(-2, 0)}, true);
  add(scene, {turned(0, 0), turned(0.5, 0), turned(0.5, 0.2), turned(0, 0.2)});
  Solid solid(scene);
  solid.settle({});
  run(solid, 1);
  EXPECT_NEAR(solid.states()[1].displacement.head<2>().norm() / (1.812815 / 2), 1, 1e-6);
}

}  // namespace
}  // namespace blockweir::solid::joints_test
