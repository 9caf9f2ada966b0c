// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Forces of a contact by their distances from Mohr-Coulomb's bounds, against derivatives and a search by hand.
#include "solid/step/bounded_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace blockweir::solid::bounded_force_test {
namespace {

const ForceRule dry{.friction = 0.6};
const ForceRule bonded{.friction = 0.6, .cohesion = 30, .least_normal = -20, .opens = false};
const ForceRule clay{.cohesion = 30};

/// The sum of the logarithms of a force's distances from its bounds.
double logarithms(const ForceRule& rule, const Eigen::Vector2d& f) {
  const double bound = rule.cohesion + rule.friction * f.x();
  double sum = std::log(bound - f.y()) + std::log(bound + f.y());
  if (rule.cohesion > 0) sum += std::log(f.x() - rule.least_normal);
  return sum;
}

Eigen::Vector2d gradient(const ForceRule& rule, const Eigen::Vector2d& f) {
  constexpr double h = 1e-4;
  Eigen::Vector2d found;
  for (const int i : {0, 1}) {
    const Eigen::Vector2d d = h * Eigen::Vector2d::Unit(i);
    found[i] = (logarithms(rule, f + d) - logarithms(rule, f - d)) / (2 * h);
  }
  return found;
}

TEST(BoundedForce, IsTheGivenOneWithinItsBounds) {
  for (const ForceRule& rule : {dry, bonded, clay}) {
    const Eigen::Vector2d given(50, -7);
    EXPECT_LT((BoundedForce(rule, given, 1e-3).force() - given).norm(), 1e-12);
    for (const Eigen::Vector2d& outside : {Eigen::Vector2d(-90, 3), {0, 0}, {10, 200}, {10, -200}}) {
      const Eigen::Vector2d f = BoundedForce(rule, outside, 1e-3).force();
      EXPECT_LT(std::abs(f.y()), rule.cohesion + rule.friction * f.x()) << outside.transpose();
      EXPECT_GT(f.x(), rule.least_normal) << outside.transpose();
    }
  }
}

void follow(BoundedForce& force, double fraction) {
  for (ComplementaryPair& p : force.distances()) {
    p.force += fraction * p.force_change;
    p.motion += fraction * p.motion_change;
  }
}

/// A step of Newton's method on the gradient, whose derivative is found by differences.
TEST(BoundedForce, ChangesByNewtonsMethod) {
  constexpr double h = 1e-2;
  const Eigen::Vector2d motion(0.013, -0.008);
  for (const ForceRule& rule : {dry, bonded, clay}) {
    const Eigen::Vector2d at(40, 11);
    BoundedForce force(rule, at, 1e-3);
    Eigen::Matrix2d derivative;
    for (const int i : {0, 1}) {
      const Eigen::Vector2d d = h * Eigen::Vector2d::Unit(i);
      derivative.col(i) = (gradient(rule, at + d) - gradient(rule, at - d)) / (2 * h);
    }
    EXPECT_LT((-force.stiffness() * derivative - Eigen::Matrix2d::Identity()).norm(), 1e-4);
    const Eigen::Vector2d to_centre = force.stiffness() * gradient(rule, at);
    EXPECT_LT((force.change_at_rest(1) - to_centre).norm(), 1e-4 * to_centre.norm());
    const Eigen::Vector2d expected = at + 0.25 * (to_centre - force.stiffness() * motion);
    force.set_changes(1, motion);
    follow(force, 0.25);
    EXPECT_LT((force.force() - expected).norm(), 1e-3);
  }
}

/// To first order in all changes, away from the centre, too.
TEST(BoundedForce, ChangesSoThatProductsComeToTheirAim) {
  const Eigen::Vector2d motion(0.013, -0.008);
  for (const ForceRule& rule : {dry, bonded, clay}) {
    BoundedForce force(rule, {40, 11}, 1e-3);
    force.set_changes(1, motion);
    follow(force, 0.2);
    double left_out = 0.01;
    for (ComplementaryPair& p : force.distances()) p.product_change = left_out += 0.02;
    const Eigen::Vector2d before = force.force();
    const Eigen::Vector2d change = force.change_at_rest(0.7) - force.stiffness() * motion;
    force.set_changes(0.7, motion);
    for (const ComplementaryPair& p : force.distances()) {
      const double product = p.force * p.motion + p.force_change * p.motion + p.force * p.motion_change;
      EXPECT_NEAR(product, 0.7 - p.product_change, 1e-12);
    }
    follow(force, 1);
    EXPECT_LT((force.force() - before - change).norm(), 1e-10);
  }
}

/// The largest loss is of the distance that vanishes first.
TEST(BoundedForce, LosesADistanceWhereItComesToItsBound) {
  for (const ForceRule& rule : {dry, bonded, clay}) {
    BoundedForce force(rule, {40, 11}, 1e-3);
    force.set_changes(1, {0.5, 0.9});
    double fraction = 1;
    for (const ComplementaryPair& p : force.distances()) fraction = std::min(fraction, p.force_fraction(1));
    ASSERT_LT(fraction, 1);
    follow(force, fraction);
    const Eigen::Vector2d f = force.force();
    const double bound = rule.cohesion + rule.friction * f.x();
    const double left = std::min({bound - f.y(), bound + f.y(), rule.cohesion > 0 ? f.x() - rule.least_normal : 1e9});
    EXPECT_NEAR(left, 0, 1e-9);
  }
}

/// What resists a motion that opens, by a search along the bounds.
TEST(BoundedForce, ResistsAnOpeningMotionByTheMostThatItsBondBears) {
  for (const ForceRule& rule : {dry, bonded, clay}) {
    BoundedForce force(rule, {40, 11}, 1e-3);
    const Eigen::Vector2d opens(0.9, 0.7);
    force.set_changes(1, opens);
    EXPECT_EQ(force.closes(), 0);
    double most = -1e30;
    for (double n = rule.least_normal; n < 400; n += 1) {
      const double bound = rule.cohesion + rule.friction * n;
      for (const double t : {-bound, bound}) most = std::max(most, -opens.dot(Eigen::Vector2d(n, t)));
    }
    EXPECT_NEAR(force.resists(), most, 1e-12);
    force.set_changes(1, {-1, 0});
    EXPECT_EQ(force.closes(), 2);
  }
}

TEST(BoundedForce, FitsOnlyHardContactsThatDoNotDilate) {
  EXPECT_TRUE(BoundedForce::fits(dry));
  EXPECT_TRUE(BoundedForce::fits(bonded));
  ForceRule other = dry;
  other.opening = {0.1, -0.1};
  EXPECT_FALSE(BoundedForce::fits(other));
  other = dry;
  other.compliance = {1e-9, 0};
  EXPECT_FALSE(BoundedForce::fits(other));
  other = dry;
  other.most_normal = 5;
  EXPECT_FALSE(BoundedForce::fits(other));
}

}  // namespace
}  // namespace blockweir::solid::bounded_force_test
