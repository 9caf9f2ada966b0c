// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Steps of a stone, and what comes of a try.
#include "solid/step/time_step.hpp"

#include <gtest/gtest.h>

#include "solid/step/impacts.hpp"
#include "solid/step/initial_equilibrium.hpp"
#include "solid/step/static_analysis.hpp"
#include "step_sample.hpp"

namespace blockweir::solid::time_step_test {
namespace {

struct Steps : Sample {
  explicit Steps(const scene::Scene& of) : Sample(of) {}
  TimeStep time_step{step, water};
  const std::vector<Panel> dry;
};

TEST(TimeStep, AStoneStandsAndAFreeOneFalls) {
  scene::Scene scene = stones(2);
  for (Point& vertex : scene.blocks[2].vertices) vertex.y() += 3;
  Steps steps(scene);
  ASSERT_EQ(steps.time_step.attempt({0.01, 0.01, steps.dry}, steps.mode), Outcome::made);
  EXPECT_NEAR(steps.state.blocks[1].displacement[1], 0, 1e-7);
  EXPECT_NEAR(steps.state.blocks[2].velocity[1], -10 * 0.01, 1e-9);
  EXPECT_EQ(steps.state.time_s, 0.01);
}

TEST(TimeStep, AStepThatGoesTooFarLeavesTheStateAsItWas) {
  scene::Scene scene = stones();
  scene.blocks[1].initial_velocity_m_per_s = {0, 100};
  Steps steps(scene);
  EXPECT_EQ(steps.time_step.attempt({0.01, 0.01, steps.dry}, steps.mode), Outcome::too_far);
  EXPECT_TRUE(steps.state.blocks[1].displacement.isZero(0));
  EXPECT_EQ(steps.state.blocks[1].velocity[1], 100);
  EXPECT_EQ(steps.step.counts.steps, 0);
}

TEST(TimeStep, AStepThatIsToBeSmoothIsNotMadeWhereAContactOpens) {
  scene::Scene scene = stones();
  scene.blocks[1].initial_velocity_m_per_s = {0, 0.3};
  Steps steps(scene);
  EXPECT_EQ(steps.time_step.attempt({0.01, 0.01, steps.dry}, {.smooth_only = true}), Outcome::contacts_change);
  EXPECT_EQ(steps.time_step.attempt({0.01, 0.01, steps.dry}, {}), Outcome::made);
  EXPECT_TRUE(steps.time_step.contacts_change());
}

TEST(TimeStep, PenaltiesAreAStepsOwnAgainAfterOneWithLaggingFriction) {
  Steps steps(stones());
  FormulationSettings& settings = steps.step.formulation->settings();
  const double usual = settings.penalty_ratio;
  const StepMode still{.scheme = {.damps = false}};
  EXPECT_EQ(StepMethods(steps.step, steps.time_step).try_with_lagging_friction({0.01, 0.01, steps.dry}, still),
            Outcome::made);
  EXPECT_EQ(settings.penalty_ratio, usual);
  EXPECT_FALSE(settings.friction_lags);
  EXPECT_EQ(steps.step.counts.lagged_steps, 1);
}

TEST(StepsWithImpacts, AStepInWhichAContactOpensIsMadeByShisScheme) {
  scene::Scene scene = stones();
  scene.analysis.integrator = scene::Integrator::trapezoidal;
  scene.blocks[1].initial_velocity_m_per_s = {0, 0.3};
  Steps steps(scene);
  steps.state.smooth_steps = State::smooth_steps_before_restart;
  StepsWithImpacts makes(steps.step, steps.time_step, steps.water);
  ASSERT_EQ(makes.make({0.01, 0.01, steps.dry}), Outcome::made);
  EXPECT_TRUE(makes.made_by_shi());
  EXPECT_EQ(steps.step.counts.impact_steps, 1);
  EXPECT_EQ(steps.state.smooth_steps, 0);
}

TEST(InitialEquilibrium, AStoneCarriesItsWeightBeforeTheRunBegins) {
  Steps steps(stones());
  EXPECT_TRUE(InitialEquilibrium(steps.step, steps.time_step).settle(steps.dry));
  EXPECT_NEAR(reaction(steps.state, 1), 25000, 1e-3);
  EXPECT_TRUE(steps.state.blocks[1].velocity.isZero(0));
  EXPECT_EQ(steps.step.counts.steps, 0);
}

TEST(InitialEquilibrium, WhatTouchesNothingWaits) {
  scene::Scene scene = stones(2);
  for (Point& vertex : scene.blocks[2].vertices) vertex.y() += 3;
  Steps steps(scene);
  EXPECT_EQ(unanchored(steps.model, steps.state), (std::vector<bool>{false, false, true}));
  InitialEquilibrium(steps.step, steps.time_step).settle(steps.dry);
  EXPECT_TRUE(steps.state.blocks[2].displacement.isZero(0));
}

TEST(StaticAnalysis, FindsAStoneAtRest) {
  scene::Scene scene = stones();
  scene.analysis.kind = scene::AnalysisKind::at_rest;
  Steps steps(scene);
  StaticAnalysis rest(steps.step, steps.time_step);
  rest.come_to_rest(steps.dry, 1);
  EXPECT_TRUE(steps.state.rest.found);
  EXPECT_LE(steps.state.rest.unbalanced, scene.analysis.residual_tolerance);
  EXPECT_EQ(steps.state.rest.unbalanced, rest.unbalanced_ratio());
}

}  // namespace
}  // namespace blockweir::solid::time_step_test
