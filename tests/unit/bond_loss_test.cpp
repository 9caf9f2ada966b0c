// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Which converged forces cost a brittle joint its bond in shear.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "solid/contact/bonds.hpp"

namespace blockweir::solid {
namespace {

const double strength = 1 + 10 * std::tan(std::acos(-1.0) / 6);  ///< of a contact, N per metre

/// Two contacts of one joint, each with a normal force of 10 N/m, in these states with these shear forces.
struct Joint {
  scene::Scene scene;
  std::vector<ContactPoint> contacts{2};

  Joint(std::array<ContactState, 2> states, std::array<double, 2> shears) {
    scene.blocks.resize(2);
    scene.default_joint.cohesion_pa = 1;
    for (std::size_t i = 0; i < 2; ++i) {
      contacts[i].edge_block = 1;
      contacts[i].bond = contacts[i].bond_length = 1;
      contacts[i].state = states[i];
      contacts[i].force = {10, shears[i]};
    }
  }
  [[nodiscard]] bool breaks() {
    const JointLaws laws(scene);
    return break_bonds(laws, 1e-9, std::array{0, 1}, contacts);
  }
};

TEST(BondLoss, AJointBreaksOnceAllOfItSlipsToOneSide) {
  Joint joint({ContactState::slip, ContactState::slip}, {strength, strength});
  EXPECT_TRUE(joint.breaks());
  EXPECT_EQ(joint.contacts[0].bond, 0);
  EXPECT_EQ(joint.contacts[1].bond, 0);
}

TEST(BondLoss, WhatSticksHoldsTheOthers) {
  EXPECT_FALSE(Joint({ContactState::slip, ContactState::stick}, {strength, 2}).breaks());
}

TEST(BondLoss, AJointThatOnlySpreadsUnderItsLoadKeepsItsBond) {
  EXPECT_FALSE(Joint({ContactState::slip, ContactState::slip}, {strength, -strength}).breaks());
}

}  // namespace
}  // namespace blockweir::solid
