// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Joints that dilate: how far a block has risen against how far it has slid, over random angles, sizes and friction.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::dilation_test {
namespace {

constexpr double g = 9.81;

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

/// A rigid block on a ground, pushed along x by that share of its weight.
scene::Scene pushed_block(double width, double height, double friction_deg, double dilation_deg, double push) {
  auto scene = empty_scene();
  scene.analysis.step_s = 2e-3 * std::sqrt(height);
  scene.analysis.max_displacement_ratio = 0.5;
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = friction_deg;
  scene.default_joint.dilation_angle_deg = dilation_deg;
  add(scene, {{-50 * width, -3}, {50 * width, -3}, {50 * width, 0}, {-50 * width, 0}}, true);
  add(scene, {{0, 0}, {width, 0}, {width, height}, {0, height}});
  scene.blocks[1].rigid = true;
  scene::BodyLoad load;
  load.blocks = {1};
  load.value[0] = scene::TimeTable::constant(push * g);
  load.value[1] = scene::TimeTable::constant(0);
  scene.body_loads.push_back(load);
  return scene;
}

Point displacement(const Solid& solid) {
  return solid.states()[1].displacement.head<2>();
}

/// Steps until it has slid so far, at most so many.
void slide(Solid& solid, double slip_m, int most_steps) {
  const double dt = solid.scene().analysis.step_s;
  for (int n = 0; n < most_steps && std::abs(displacement(solid).x()) < slip_m; ++n) {
    const double now = solid.time_s();
    solid.advance(now, now + dt, {});
  }
}

/// With N - W = m y", y = x tan(psi): x" (1 + tan(psi) tan(phi)) = push g - g tan(phi).
TEST(Dilation, ABlockThatSlidesRisesByTheTangentOfItsAngle) {
  for (int seed = 1; seed <= test::campaign(20); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    const double height = random.over_decades(1e-2, 100);
    const double friction = random.between(10, 40);
    const double dilation = friction * random.between(0.1, 1);
    const double push = tangent(friction) + random.between(0.05, 0.3);
    const double width = height * push * random.between(2, 6);
    auto scene = pushed_block(width, height, friction, dilation, push);
    scene.contact.formulation = seed % 2 == 0 ? scene::ContactFormulation::augmented_lagrangian
                                              : scene::ContactFormulation::lagrange_multiplier;
    Solid solid(scene);
    solid.settle({});
    slide(solid, width, 5000);
    const Point moved = displacement(solid);
    EXPECT_GT(moved.x(), 0.9 * width) << "seed " << seed;
    EXPECT_NEAR(moved.y() / (moved.x() * tangent(dilation)), 1, 1e-6) << "seed " << seed;
    EXPECT_LT(std::abs(solid.states()[1].displacement[2]), 1e-9) << "seed " << seed;
    const double acceleration = (push - tangent(friction)) * g / (1 + tangent(dilation) * tangent(friction));
    const double time = solid.time_s();
    EXPECT_NEAR(moved.x() / (acceleration * time * time / 2), 1, 2 * scene.analysis.step_s / time) << "seed " << seed;
  }
}

TEST(Dilation, GoingBackClosesTheJoint) {
  for (int seed = 1; seed <= test::campaign(10); ++seed) {
    test::Random random(static_cast<unsigned>(100 + seed));
    const double friction = random.between(10, 40);
    const double dilation = friction * random.between(0.1, 0.8);
    const double push = tangent(friction) + 0.2;
    auto scene = pushed_block(5, 1, friction, dilation, push);
    scene.body_loads[0].value[0] = {.time_s = {0, 0.2, 0.2001}, .value = {push * g, push * g, -push * g}};
    Solid solid(scene);
    solid.settle({});
    double farthest = 0;
    for (int n = 0; n < 600; ++n) {
      solid.advance(solid.time_s(), solid.time_s() + scene.analysis.step_s, {});
      const Point moved = displacement(solid);
      if (moved.x() < -0.1) break;
      farthest = std::max(farthest, moved.x());
      ASSERT_NEAR(moved.y(), std::abs(moved.x()) * tangent(dilation), 1e-3 * tangent(dilation) * farthest + 1e-4)
          << "seed " << seed << " at " << moved.x();
    }
    EXPECT_GT(farthest, 0.02) << "seed " << seed;
  }
}

/// Thrown up while it slides, the block comes down on the teeth where it then is.
TEST(Dilation, AJointThatOpensAndClosesAgainRemembersItsSlip) {
  for (int seed = 1; seed <= test::campaign(10); ++seed) {
    test::Random random(static_cast<unsigned>(200 + seed));
    const double friction = random.between(15, 40);
    const double dilation = friction * random.between(0.3, 0.8);
    const double push = tangent(friction) + 0.1;
    auto scene = pushed_block(5, 1, friction, dilation, push);
    // 1.5 times its weight lifts it for a tenth of a second: by centimetres, farther than a search reaches.
    scene.body_loads[0].value[1] = {.time_s = {0, 0.4, 0.4001, 0.5, 0.5001}, .value = {0, 0, 2.5 * g, 2.5 * g, 0}};
    Solid solid(scene);
    solid.settle({});
    double highest = 0;
    while (solid.time_s() < 1.5) {
      solid.advance(solid.time_s(), solid.time_s() + scene.analysis.step_s, {});
      const Point moved = displacement(solid);
      highest = std::max(highest, moved.y() - moved.x() * tangent(dilation));
      ASSERT_GT(moved.y(), moved.x() * tangent(dilation) - 1e-6) << "seed " << seed << " at " << moved.x();
    }
    EXPECT_GT(highest, 0.05) << "seed " << seed;
    const Point moved = displacement(solid);
    EXPECT_NEAR(moved.y(), moved.x() * tangent(dilation), 1e-6) << "seed " << seed;
  }
}

/// Its vertices pass from edge to edge, and past the ground's end the ground's corner takes over.
TEST(Dilation, ContactsThatAreHandedOnKeepTheSlipOfTheirJoint) {
  for (int seed = 1; seed <= test::campaign(10); ++seed) {
    test::Random random(static_cast<unsigned>(300 + seed));
    const double friction = random.between(10, 40);
    const double dilation = friction * random.between(0.3, 1);
    auto scene = pushed_block(4, 1, friction, dilation, tangent(friction) + 0.1);
    scene.blocks[0].vertices = {{-1, -3}, {5.2, -3}, {5.2, 0}, {4.7, 0}, {4.3, 0}, {0.6, 0}, {0.2, 0}, {-1, 0}};
    Solid solid(scene);
    solid.settle({});
    slide(solid, 2.5, 5000);
    const Point moved = displacement(solid);
    EXPECT_GT(moved.x(), 2.4) << "seed " << seed;
    EXPECT_NEAR(moved.y() / (moved.x() * tangent(dilation)), 1, 1e-5) << "seed " << seed;
  }
}

}  // namespace
}  // namespace blockweir::solid::dilation_test
