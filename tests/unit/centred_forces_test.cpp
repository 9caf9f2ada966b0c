// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Forces by which blocks that rest go on resting: those farthest from their bounds, if there are any.
#include "solid/step/centred_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "step_sample.hpp"

namespace blockweir::solid::centred_forces_test {
namespace {

constexpr double weight = 25000;
const double friction = std::tan(30 * std::numbers::pi / 180);

struct Pushed : Sample {
  explicit Pushed(double push_n, const scene::Scene& of = stones()) : Sample(of) {
    begin();
    step.trial.external[1][0] += push_n;
  }
  Held found() { return CentredForces(step).hold(island()); }
  bool hold() { return found() == Held::yes; }
  [[nodiscard]] Eigen::Vector2d force() const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const ContactPoint& c : state.contacts) sum += c.force;
    return sum;
  }
};

TEST(CentredForces, BearAStoneWithoutShear) {
  Pushed stone(0);
  ASSERT_TRUE(stone.hold());
  EXPECT_NEAR(stone.force().x(), weight, 1e-3);
  for (const ContactPoint& c : stone.state.contacts) {
    EXPECT_EQ(c.state, ContactState::stick);
    EXPECT_NEAR(c.force.y(), 0, 1e-3);
  }
  EXPECT_EQ(stone.step.trial.largest_increment(), 0);
}

TEST(CentredForces, HoldAPushUpToFrictionAndNoMore) {
  for (const double share : {0.5, 0.99, 0.9999}) {
    Pushed stone(share * friction * weight);
    ASSERT_TRUE(stone.hold()) << share;
    EXPECT_NEAR(std::abs(stone.force().y()), share * friction * weight, 1e-3);
    for (const ContactPoint& c : stone.state.contacts) {
      EXPECT_LE(std::abs(c.force.y()), friction * c.force.x()) << share;
    }
  }
  for (const double share : {1.0001, 1.01, 3.0}) EXPECT_FALSE(Pushed(share * friction * weight).hold()) << share;
}

/// Of a stone at its limit of turning over the forces at the heel vanish.
TEST(CentredForces, HoldAStoneUntilItTurnsOver) {
  scene::Scene rough = stones();
  rough.default_joint.friction_angle_deg = rough.default_joint.residual_friction_angle_deg = 60;
  EXPECT_TRUE(Pushed(0.999 * weight, rough).hold());
  EXPECT_FALSE(Pushed(1.001 * weight, rough).hold());
}

TEST(CentredForces, AreFoundInFewSolutions) {
  Pushed stone(0.5 * friction * weight);
  ASSERT_TRUE(stone.hold());
  EXPECT_LE(stone.step.counts.iterations, 8);
  const long before = stone.step.counts.iterations;
  stone.step.trial.external[1][0] += 10;
  ASSERT_TRUE(stone.hold());
  EXPECT_EQ(stone.step.counts.iterations, before + 1) << "from the forces before one solution follows the load";
  Pushed over(1.1 * friction * weight);
  EXPECT_EQ(over.found(), Held::no);
  EXPECT_LE(over.step.counts.iterations, 12) << "Farkas' lemma shows it soon";
}

TEST(CentredForces, AreForManyRigidBlocksAtRest) {
  const auto may = [](Sample& sample) {
    sample.begin();
    return CentredForces(sample.step).may_hold(sample.island(), sample.mode);
  };
  Sample few(stones());
  EXPECT_FALSE(may(few)) << "Newton's method finds their forces";
  scene::Scene column = stones();
  for (int k = 1; k < 30; ++k) {
    column.blocks.push_back({.name = "above " + std::to_string(k), .vertices = column.blocks[1].vertices});
    for (scene::Point& p : column.blocks.back().vertices) p.y() += k;
  }
  Sample many(column);
  EXPECT_TRUE(may(many));
  many.state.blocks[7].velocity[0] = 0.1;
  EXPECT_FALSE(may(many)) << "one moves";
  column.analysis.rigid = scene::Rigid::none;
  Sample strains(column);
  EXPECT_FALSE(may(strains));
}

}  // namespace
}  // namespace blockweir::solid::centred_forces_test
