// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// What follows once a step's equilibrium is found: velocities, energy, overlaps.
#include <gtest/gtest.h>

#include <cmath>

#include "solid/step/constrained_velocities.hpp"
#include "solid/step/newton.hpp"
#include "solid/step/push_apart.hpp"
#include "solid/step/step_energy.hpp"
#include "step_sample.hpp"

namespace blockweir::solid::step_end_test {
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

/// Of a stone's lower left corner at this place, the lower side of the stone dipping by 0.07 rad, with the floor of a
/// ledge: that ends on its left at a wall of 0.3 m, in a notch.
Meeting with_floor(const Point& corner) {
  constexpr double dip = 0.07;
  scene::Scene scene = stones();
  scene.blocks[0].vertices = {{-5, -1}, {15, -1}, {15, 0}, {0, 0}, {0, 0.3}, {-5, 0.3}};
  const Point along(std::cos(dip), -std::sin(dip));
  const Point up(std::sin(dip), std::cos(dip));
  scene.blocks[1].vertices = {corner, corner + along, corner + along + up, corner + up};
  Sample sample(scene);
  sample.begin(dt);
  const ContactSide& floor = sample.model.parts.contact_outlines[0][2];
  ContactPoint c;
  c.vertex_block = c.vertex_part = 1;
  c.vertex_at = sample.model.parts.contact_outlines[1][0].from;
  c.edge = 2;
  c.edge_from = floor.from;
  c.edge_to = floor.to;
  return Meetings(sample.step).of_contact(c);
}

TEST(Meetings, PastAFaceThatEndsInANotchAreInFrontOfItsLine) {
  EXPECT_NEAR(with_floor({-0.2, 0.4}).gap, 0.4, 1e-9) << "-0.2 m before: over the wall, but behind its face";
}

TEST(Meetings, BehindAFaceAreOverlapsInItsBlockAlone) {
  EXPECT_NEAR(with_floor({5, -0.001}).gap, -0.001, 1e-9);
  EXPECT_TRUE(std::isinf(with_floor({5, -4}).gap));
}

TEST(Meetings, OfACornerFarBehindAFaceLeadOutByTheNearest) {
  const Meeting meeting = with_floor({-3, -0.9});
  EXPECT_NEAR(meeting.gap, -0.1, 1e-9);
  EXPECT_NEAR(meeting.normal.y(), -1, 1e-9);
}

}  // namespace
}  // namespace blockweir::solid::step_end_test
