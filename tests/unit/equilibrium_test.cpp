// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// The methods that find the equilibrium of an island agree on a stone that stands.
#include "solid/step/equilibrium.hpp"

#include <gtest/gtest.h>

#include "solid/step/lagging_friction.hpp"
#include "solid/step/newton.hpp"
#include "solid/step/pivoting.hpp"
#include "solid/step/restore_unless.hpp"
#include "solid/step/swept_equilibrium.hpp"
#include "step_sample.hpp"

namespace blockweir::solid::equilibrium_test {
namespace {

constexpr double weight = 25000;

TEST(Newton, FindsTheForcesUnderAStone) {
  Sample sample(stones());
  sample.begin();
  EXPECT_TRUE(Newton(sample.step).find(sample.island(), sample.mode));
  EXPECT_NEAR(reaction(sample.state, 1), weight, 1);
}

TEST(LaggingFriction, FindsTheForcesUnderAStone) {
  Sample sample(stones());
  sample.begin();
  sample.step.formulation->settings().friction_lags = true;
  EXPECT_TRUE(LaggingFriction(sample.step).find(sample.island(), sample.mode.with_lagging_friction()));
  EXPECT_NEAR(reaction(sample.state, 1), weight, 1);
}

TEST(Pivoting, FindsTheForcesUnderAStoneThatNoBondHolds) {
  Sample sample(stones());
  sample.begin();
  ASSERT_TRUE(Pivoting(sample.step).find(sample.island(), sample.mode));
  EXPECT_EQ(sample.step.counts.pivoted_islands, 1);
  EXPECT_NEAR(reaction(sample.state, 1), weight, 1);
}

TEST(SweptEquilibrium, OfASmallIslandIsFinishedByNewtonsMethod) {
  Sample sample(stones());
  sample.begin();
  EXPECT_EQ(SweptEquilibrium(sample.step).find(sample.island(), sample.mode), Found::by_newton_after_sweeps);
  EXPECT_EQ(sample.step.counts.swept_islands, 1);
  EXPECT_NEAR(reaction(sample.state, 1), weight, 1);
}

TEST(SweptEquilibrium, WhatNothingTouchesFliesByOneSolution) {
  scene::Scene above = stones();
  for (scene::Point& p : above.blocks[1].vertices) p.y() += 5;
  Sample sample(above);
  sample.begin();
  ASSERT_TRUE(sample.island().is_free());
  EXPECT_EQ(SweptEquilibrium(sample.step).find(sample.island(), sample.mode), Found::by_newton_after_sweeps);
  EXPECT_EQ(sample.step.counts.swept_islands, 0);
  EXPECT_NEAR(sample.step.trial.increment[1][1], -10 * 0.01 * 0.01 / 2, 1e-16);
  EXPECT_EQ(sample.island().unbalanced(), 0);
}

TEST(Equilibrium, SweepsOnlyWhereAModeLetsItAndNewtonsMethodIsNotWorthATry) {
  Sample sample(stones());
  sample.begin();
  StepMode still{.scheme = {.damps = false}};
  EXPECT_FALSE(may_sweep(sample.step, still));
  EXPECT_TRUE(may_sweep(sample.step, still.with_sweeps()));
  still.smooth_only = true;
  EXPECT_FALSE(may_sweep(sample.step, still.with_sweeps()));
  EXPECT_EQ(find_equilibrium(sample.step, sample.island(), sample.mode, /*newton=*/true), Found::by_newton);
  EXPECT_EQ(sample.step.counts.swept_islands, 0);
}

TEST(Undo, ASearchInVainLeavesTheTrialAsItWas) {
  Sample sample(stones());
  sample.begin();
  const auto in_vain = [&] {
    sample.step.trial.go_to(1, Vector6::Constant(1e-3));
    for (ContactPoint& c : sample.state.contacts) c.penalty = 7;
    return false;
  };
  const double penalty = sample.state.contacts[0].penalty;
  EXPECT_FALSE(restore_unless(sample.step, sample.island(), sample.mode, in_vain));
  EXPECT_TRUE(sample.step.trial.increment[1].isZero(0));
  EXPECT_EQ(sample.state.contacts[0].penalty, penalty);
}

}  // namespace
}  // namespace blockweir::solid::equilibrium_test
