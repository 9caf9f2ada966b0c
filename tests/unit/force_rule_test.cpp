// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Forces of one point: the law holds, whatever the flexibility and the motion without them.
#include "solid/contact/force_rule.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace blockweir::solid::force_rule_test {
namespace {

const Eigen::Matrix2d round = Eigen::Matrix2d::Identity();

TEST(ForceRule, AGapThatStaysOpenHasNoForce) {
  EXPECT_TRUE(forces_of({.friction = 0.5, .cohesion = 3}, round, {0.1, 2}).force.isZero(0));
}

TEST(ForceRule, WhatIsPressedSticksWithinFriction) {
  const RuledForce found = forces_of({.friction = 0.5}, round, {-2, 0.9});
  EXPECT_EQ(found.force, Eigen::Vector2d(2, -0.9));
  EXPECT_FALSE(found.slips);
}

TEST(ForceRule, BeyondFrictionItSlipsAtTheBoundAgainstTheSlip) {
  const RuledForce found = forces_of({.friction = 0.5, .cohesion = 0.25}, round, {-2, -9});
  EXPECT_EQ(found.force, Eigen::Vector2d(2, 1.25));
  EXPECT_TRUE(found.slips);
}

TEST(ForceRule, ABondPulls) {
  const ForceRule bond{.cohesion = 1, .least_normal = -ForceRule::unbounded, .opens = false};
  EXPECT_EQ(forces_of(bond, round, {3, 0.5}).force, Eigen::Vector2d(-3, -0.5));
}

TEST(ForceRule, ASpringGivesWay) {
  ForceRule spring;
  spring.compliance.setConstant(3);
  EXPECT_DOUBLE_EQ(forces_of(spring, round, {-2, 0}).force.x(), 0.5);
}

/// A bolt yields in tension, which is a normal force below zero, and takes no compression.
TEST(ForceRule, ABoltYieldsAndGoesSlack) {
  const ForceRule bolt{.least_normal = -2, .most_normal = 0, .opens = false};
  EXPECT_DOUBLE_EQ(forces_of(bolt, round, {1.5, 0}).force.x(), -1.5);
  EXPECT_DOUBLE_EQ(forces_of(bolt, round, {7, 0}).force.x(), -2);
  EXPECT_DOUBLE_EQ(forces_of(bolt, round, {-7, 0}).force.x(), 0);
}

TEST(ForceRule, WhatDilatesOpensAsItSlips) {
  const ForceRule rule{.friction = 0.5, .opening = {0.2, -0.2}};
  const RuledForce found = forces_of(rule, round, {-2, 9});
  const Eigen::Vector2d apart = Eigen::Vector2d(-2, 9) + found.force;
  EXPECT_TRUE(found.slips);
  EXPECT_NEAR(apart.x(), 0.2 * apart.y(), 1e-14);
  EXPECT_NEAR(found.force.y(), -0.5 * found.force.x(), 1e-14);
}

Eigen::Matrix2d any_flexibility(std::mt19937& random) {
  std::normal_distribution<double> any;
  Eigen::Matrix2d root;
  root << any(random), any(random), any(random), any(random);
  return root * root.transpose() + 0.05 * round;
}

TEST(ForceRule, HoldsForRandomPoints) {
  std::mt19937 random(1);
  std::normal_distribution<double> any;
  std::uniform_real_distribution<double> share;
  for (int k = 0; k < 20000; ++k) {
    const Eigen::Matrix2d W = any_flexibility(random);
    // As steep as friction may be before a point jams.
    const double most = 0.9 * W(0, 0) / (std::abs(W(0, 1)) + 1e-12);
    const ForceRule rule{.friction = std::min(2.0, most) * share(random), .cohesion = share(random) < 0.5 ? 0 : 0.3};
    const Eigen::Vector2d without{any(random), any(random)};
    const auto [force, slips, exact] = forces_of(rule, W, without);
    const Eigen::Vector2d apart = without + W * force;
    const double round_off = 1e-9 * (1 + without.norm());
    if (force.isZero(0)) {
      EXPECT_GE(apart.x(), 0) << k;
      continue;
    }
    EXPECT_GE(force.x(), -round_off) << k;
    EXPECT_NEAR(force.x() * apart.x(), 0, round_off) << k;
    const double bound = rule.cohesion + rule.friction * force.x();
    EXPECT_LE(std::abs(force.y()), bound + round_off) << k;
    if (slips) {
      EXPECT_LE(force.y() * apart.y(), round_off) << k;
    } else {
      EXPECT_NEAR(apart.y(), 0, round_off) << k;
    }
  }
}

TEST(ForceRule, OfADryPointIsTheSameInFewerOperations) {
  std::mt19937 random(2);
  std::normal_distribution<double> any;
  std::uniform_real_distribution<double> share;
  for (int k = 0; k < 20000; ++k) {
    const Eigen::Matrix2d W = any_flexibility(random);
    const PointForces<double> point(law_of({.friction = 3 * share(random)}, W));  // steep ones jam
    const double gap = any(random);
    const double slip = any(random);
    const auto expected = point.at(gap, slip);
    const auto found = point.at<true>(gap, slip);
    EXPECT_EQ(found.normal, expected.normal) << k;
    EXPECT_EQ(found.shear, expected.shear) << k;
    EXPECT_EQ(found.slips, expected.slips) << k;
  }
}

}  // namespace
}  // namespace blockweir::solid::force_rule_test
