// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// All that a step changes.
#include "solid/step/state.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "step_sample.hpp"

namespace blockweir::solid::state_test {
namespace {

TEST(State, BeginsAsTheSceneIsDrawnWithBlocksThatTouchJoined) {
  const scene::Scene scene = stones();
  Model model(scene);
  const State state(model);
  EXPECT_EQ(state.touching_contacts(), 2);
  for (const ContactPoint& c : state.contacts) EXPECT_TRUE(c.bonded());
  EXPECT_EQ(state.largest_displacement_m(model), 0);
}

TEST(State, AGapOfRoundedCoordinatesCountsAsNone) {
  scene::Scene scene = stones();
  for (Point& vertex : scene.blocks[1].vertices) vertex.y() += 1e-8;
  Model model(scene);
  const State state(model);
  ASSERT_EQ(state.touching_contacts(), 2);
  for (const ContactPoint& c : state.contacts) {
    if (c.state == ContactState::open) continue;
    EXPECT_EQ(c.gap, 0);
    EXPECT_NEAR(c.gap_at_start, 1e-8, 1e-15);
  }
}

TEST(State, ACopyIsTheUndo) {
  const scene::Scene scene = stones();
  Model model(scene);
  State state(model);
  const Standing before = state;
  state.blocks[1].displacement[0] = 0.3;
  state.contacts.clear();
  state.contacts_stand = true;
  state.restore(before);
  EXPECT_EQ(state.blocks[1].displacement[0], 0);
  EXPECT_EQ(state.touching_contacts(), 2);
  EXPECT_FALSE(state.contacts_stand);  // they are to be searched again
}

TEST(State, WhatStopsHasNoVelocity) {
  scene::Scene scene = stones();
  scene.blocks[1].initial_velocity_m_per_s = {3, 0};
  Model model(scene);
  State state(model);
  EXPECT_EQ(state.blocks[1].velocity[0], 3);
  state.stop();
  EXPECT_TRUE(state.blocks[1].velocity.isZero(0));
}

TEST(State, ACheckpointOfAnotherNumberOfBlocksIsRefused) {
  const scene::Scene scene = stones();
  Model model(scene);
  State state(model);
  state.blocks[1].displacement[0] = 0.3;
  state.place_blocks(model);
  EXPECT_DOUBLE_EQ(state.largest_displacement_m(model), 0.3);
  state.blocks.pop_back();
  EXPECT_THROW(state.place_blocks(model), std::runtime_error);
}

}  // namespace
}  // namespace blockweir::solid::state_test
