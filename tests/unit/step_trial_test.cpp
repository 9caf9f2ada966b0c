// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// What a step tries.
#include "solid/step/step_trial.hpp"

#include <gtest/gtest.h>

#include "step_sample.hpp"

namespace blockweir::solid::step_trial_test {
namespace {

TEST(StepTrial, BlocksGoOnAsTheyMove) {
  scene::Scene scene = stones();
  scene.blocks[1].initial_velocity_m_per_s = {3, 0};
  Sample sample(scene);
  sample.begin(0.01);
  EXPECT_DOUBLE_EQ(sample.step.trial.increment[1][0], 0.03);
  EXPECT_DOUBLE_EQ(sample.step.trial.placement[1].centre().x(), 0.53);
  EXPECT_TRUE(sample.step.trial.increment[0].isZero(0));
  EXPECT_TRUE(sample.step.trial.at_start().increment[1].isZero(0));
}

TEST(StepTrial, OnlyWhatIsNotFixedHasUnknowns) {
  Sample sample(stones());
  EXPECT_FALSE(sample.step.trial.moves(-1));
  EXPECT_FALSE(sample.step.trial.moves(0));
  EXPECT_TRUE(sample.step.trial.moves(1));
}

TEST(StepTrial, MatricesAreMadeForAStepAndAnIntegrator) {
  Sample sample(stones());
  sample.begin(0.01);
  StepTrial& trial = sample.step.trial;
  EXPECT_DOUBLE_EQ(trial.matrix[1](0, 0), 2 * 2500 / (0.01 * 0.01));  // Shi's scheme: 2 m/dt^2
  trial.set_matrices(0.01, Newmark::of(scene::Integrator::trapezoidal, 0));
  EXPECT_DOUBLE_EQ(trial.matrix[1](0, 0), 4 * 2500 / (0.01 * 0.01));
}

TEST(StepTrial, AStepGoesTooFarByAPathOrByATurn) {
  Sample sample(stones());
  sample.begin(0.01);
  StepTrial& trial = sample.step.trial;
  Vector6 moved = Vector6::Zero();
  EXPECT_FALSE(trial.goes_too_far());
  moved[0] = 2 * sample.scene.analysis.max_displacement_ratio * sample.model.size_m;
  trial.go_to(1, moved);
  trial.moved_m = trial.largest_increment();
  EXPECT_DOUBLE_EQ(trial.moved_m, moved[0]);
  EXPECT_TRUE(trial.goes_too_far());
  moved[0] = 0;
  moved[2] = 2 * ContactSearch::most_turn;
  trial.go_to(1, moved);
  trial.moved_m = 1e-6;
  EXPECT_TRUE(trial.goes_too_far());
}

// A load may turn a block into another that it has no contact with as the step begins.
TEST(StepTrial, ABlockNearOthersTurnsNoFartherWithoutAContact) {
  Sample sample(stones());
  sample.begin(0.01);
  ASSERT_FALSE(sample.state.search.near_pairs().empty());
  sample.state.contacts.clear();
  Vector6 moved = Vector6::Zero();
  moved[2] = 2 * ContactSearch::most_turn;
  StepTrial& trial = sample.step.trial;
  trial.go_to(1, moved);
  trial.moved_m = 1e-6;
  EXPECT_TRUE(trial.goes_too_far());
}

TEST(StepTrial, AFallIsThatOfGravity) {
  Sample sample(stones());
  sample.begin(0.1);
  EXPECT_DOUBLE_EQ(sample.step.trial.fall_m(), 10 * 0.1 * 0.1);
}

}  // namespace
}  // namespace blockweir::solid::step_trial_test
