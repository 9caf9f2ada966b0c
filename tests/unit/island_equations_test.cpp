// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Residual and matrix of one island.
#include "solid/step/island_equations.hpp"

#include <gtest/gtest.h>

#include "step_sample.hpp"

namespace blockweir::solid::island_equations_test {
namespace {

TEST(IslandEquations, AtRestTheWeightIsUnbalanced) {
  Sample sample(stones());
  sample.begin();
  IslandEquations& s = sample.island();
  EXPECT_NEAR(s.unbalanced(), 25000, 1e-6);
  EXPECT_NEAR(s.residual[1], -25000, 1e-6);
}

/// The contacts' own stiffness at the trial, by central differences of the residual.
TEST(IslandEquations, TheMatrixIsTheDerivativeOfTheResidual) {
  Sample sample(stones());
  sample.begin();
  IslandEquations& s = sample.island();
  Vector6 in = Vector6::Zero();
  in[1] = -1e-6;  // both corners in touch
  sample.step.trial.go_to(1, in);
  s.unbalanced();
  ASSERT_TRUE(s.solve_linearized());
  const Eigen::MatrixXd matrix = s.system().dense();
  constexpr double little = 1e-9;
  for (int i = 0; i < 3; ++i) {
    Vector6 other = in;
    other[i] += little;
    sample.step.trial.go_to(1, other);
    s.unbalanced();
    const Eigen::VectorXd after = s.residual;
    other[i] -= 2 * little;
    sample.step.trial.go_to(1, other);
    s.unbalanced();
    const Eigen::VectorXd slope = (s.residual - after) / (2 * little);
    EXPECT_LE((slope - matrix.col(i)).norm(), 1e-5 * matrix.norm()) << i;
  }
}

TEST(IslandEquations, TheCorrectionMovesTheTrial) {
  Sample sample(stones());
  sample.begin();
  IslandEquations& s = sample.island();
  s.correction.setZero();
  s.correction[0] = 0.2;
  s.move(0.5);
  EXPECT_DOUBLE_EQ(sample.step.trial.increment[1][0], 0.1);
}

TEST(StepIslands, StonesThatDoNotTouchAreIslandsOfTheirOwnAndKeptWhileContactsStand) {
  Sample sample(stones(3));
  sample.begin();
  EXPECT_EQ(sample.islands.end() - sample.islands.begin(), 3);
  EXPECT_EQ(sample.step.counts.most_islands, 3);
  const IslandEquations* before = &sample.island();
  sample.islands.prepare();
  EXPECT_EQ(before, &sample.island());
  EXPECT_EQ(before->local(1), 0);
}

TEST(StepIslands, WhatNothingTouchesKeepsItsEquationsWhileOthersPart) {
  scene::Scene one_above = stones(2);
  for (scene::Point& p : one_above.blocks[2].vertices) p.y() += 5;
  Sample sample(one_above);
  sample.begin();
  IslandEquations* const first = &*sample.islands.begin();
  first[0].residual[0] = first[1].residual[0] = 7;
  sample.state.contacts.clear();
  sample.islands.prepare();
  ASSERT_EQ(sample.islands.size(), 2);
  IslandEquations* const now = &*sample.islands.begin();
  EXPECT_TRUE(now[0].is_free());
  EXPECT_TRUE(now[0].incidence.of(0).empty());
  EXPECT_EQ(now[1].residual[0], 7);
}

}  // namespace
}  // namespace blockweir::solid::island_equations_test
