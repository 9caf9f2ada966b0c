// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// What follows once a step's equilibrium is found: velocities, energy, overlaps.
#include <gtest/gtest.h>

#include "solid/step/constrained_velocities.hpp"
#include "solid/step/newton.hpp"
#include "solid/step/push_apart.hpp"
#include "solid/step/step_energy.hpp"
#include "step_sample.hpp"

namespace blockweir::solid {
namespace {

constexpr double dt = 0.01;

scene::Scene lifted_stone() {
  scene::Scene scene = stones();
  for (Point& vertex : scene.blocks[1].vertices) vertex.y() += 3;
  return scene;
}

TEST(ConstrainedVelocities, OfAStoneThatStandsBecomeTheStepsMean) {
  Sample sample(stones());
  sample.begin(dt);
  ASSERT_TRUE(Newton(sample.step).find(sample.island(), sample.mode));
  sample.island().found = Found::by_newton;
  sample.state.blocks[1].velocity[1] = -0.5;
  ConstrainedVelocities(sample.step).settle(sample.island(), dt);
  EXPECT_NEAR(sample.state.blocks[1].velocity[1], 0, 1e-4);
}

TEST(ConstrainedVelocities, OfAStoneInTheAirStay) {
  Sample sample(lifted_stone());
  sample.begin(dt);
  ASSERT_TRUE(Newton(sample.step).find(sample.island(), sample.mode));
  sample.state.blocks[1].velocity[1] = -0.5;
  ConstrainedVelocities(sample.step).settle(sample.island(), dt);
  EXPECT_EQ(sample.state.blocks[1].velocity[1], -0.5);
}

TEST(StepEnergy, WhatAFallGivesIsThereForMotion) {
  Sample sample(lifted_stone());
  sample.begin(dt);
  ASSERT_TRUE(Newton(sample.step).find(sample.island(), sample.mode));
  StepEnergy(sample.step).balance(sample.island(), dt);
  const double fall = 10 * dt * dt / 2;  // by Shi's scheme: g dt^2/2
  EXPECT_NEAR(sample.step.trial.for_motion[1], 25000 * fall, 1e-9);
  EXPECT_NEAR(sample.state.energy.given_j_per_m(), 0, 1e-12);  // weight is potential energy
}

TEST(StepEnergy, WhatAStoneCannotGiveBackIsOwed) {
  Sample sample(lifted_stone());
  sample.begin(dt);
  ASSERT_TRUE(Newton(sample.step).find(sample.island(), sample.mode));
  sample.step.trial.for_motion[1] = 0;
  sample.state.blocks[1].velocity[0] = 2;  // all of it momentum, which stays
  StepEnergy(sample.step).take_back(sample.island());
  EXPECT_NEAR(sample.state.blocks[1].velocity[0], 2, 1e-12);
  EXPECT_NEAR(sample.state.energy.owed(1), 2500 * 2 * 2 / 2., 1e-6);
}

TEST(PushApart, AStoneInTheGroundIsLiftedOutOfIt) {
  Sample sample(stones());
  sample.begin(dt);
  ASSERT_TRUE(Newton(sample.step).find(sample.island(), sample.mode));
  sample.island().found = Found::by_sweeps;
  sample.step.formulation->settings().lasting_overlap_m = 1e-7;
  sample.state.blocks[1].displacement[1] = -1e-4;
  sample.state.place_blocks(sample.model);
  EXPECT_TRUE(PushApart(sample.step).push(sample.island()));
  EXPECT_NEAR(sample.state.blocks[1].displacement[1], 0, 2e-7);
  EXPECT_FALSE(PushApart(sample.step).push(sample.island()));
}

}  // namespace
}  // namespace blockweir::solid
