// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Which converged forces cost a brittle joint its bond in shear.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "solid/contact/bonds.hpp"

namespace blockweir::solid::bond_loss_test {
namespace {

const double strength = 1 + 10 * std::tan(std::acos(-1.0) / 6);  ///< of a contact, N per metre

/// Two contacts of one joint, each with a normal force of 10 N/m, in these states with these shear forces.
struct Joint {
  scene::Scene scene;
  std::vector<Block> blocks{2};
  std::vector<ContactPoint> contacts{2};

  Joint(std::array<ContactState, 2> states, std::array<double, 2> shears) {
    scene.blocks.resize(2);
    for (Block& block : blocks) block.centroid = Point::Zero();
    scene.default_joint.cohesion_pa = 1;
    for (std::size_t i = 0; i < 2; ++i) {
      contacts[i].edge_block = contacts[i].edge_part = 1;
      contacts[i].vertex_at = {static_cast<double>(i), 0};
      contacts[i].edge_to = {1, 0};
      contacts[i].bond = contacts[i].bond_length = 1;
      contacts[i].state = states[i];
      contacts[i].force = {10, shears[i]};
    }
  }
  [[nodiscard]] bool breaks() {
    const JointLaws laws(scene);
    std::vector<int> all(contacts.size());
    std::iota(all.begin(), all.end(), 0);
    return break_bonds(laws, 1e-9, blocks, all, contacts);
  }
  /// A third contact beside the first, on an edge that falls away by that.
  void add_at_first(double fall) {
    contacts.push_back(contacts[0]);
    contacts[2].edge_from = {-1, fall};
    contacts[2].edge_to = {0, 0};
    contacts[2].bond_length = 0;
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

/// A heel in the valley between its base and the ground before it.
TEST(BondLoss, WhatSlipsAlongTwoFacesAtAnAngleOnlyStrainsAndKeepsItsBond) {
  Joint joint({ContactState::slip, ContactState::slip}, {strength, strength});
  joint.add_at_first(0.06);
  EXPECT_FALSE(joint.breaks());
  joint.contacts[2].state = ContactState::open;
  EXPECT_TRUE(joint.breaks());
}

TEST(BondLoss, FacesThatAreInOneLineButForRoundingSlipTogether) {
  Joint joint({ContactState::slip, ContactState::slip}, {strength, strength});
  joint.add_at_first(1e-5);
  EXPECT_TRUE(joint.breaks());
}

}  // namespace
}  // namespace blockweir::solid::bond_loss_test
