// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Mohr-Coulomb at one contact, and the broad phase against all pairs.
#include <gtest/gtest.h>

#include <random>

#include "solid/contact/joint_law.hpp"
#include "solid/contact/neighbours.hpp"

namespace blockweir::solid::joint_law_test {
namespace {

TEST(JointLaw, HoldsShearUpToFrictionAndCohesion) {
  const Strength strength{.friction = 0.5, .cohesion = 10, .tension = 5};
  EXPECT_EQ(admissible(strength, 100, 59).state, ContactState::stick);
  const JointForce slips = admissible(strength, 100, -61);
  EXPECT_EQ(slips.state, ContactState::slip);
  EXPECT_DOUBLE_EQ(slips.shear, -60);
  EXPECT_DOUBLE_EQ(slips.shear_per_normal, -0.5);
}

TEST(JointLaw, OpensBeyondItsTensionStrength) {
  const Strength strength{.friction = 0.5, .cohesion = 10, .tension = 5};
  EXPECT_EQ(admissible(strength, -4, 0).state, ContactState::stick);
  EXPECT_EQ(admissible(strength, -6, 0).state, ContactState::open);
  EXPECT_EQ(admissible({.friction = 0.5}, 0, 0).state, ContactState::open);
}

TEST(JointLaw, WithABoundThatLagsShearDoesNotDependOnTheNormalForce) {
  const Strength strength{.friction = 0.5};
  const JointForce slips = admissible(strength, 20, 100, -30);
  EXPECT_EQ(slips.state, ContactState::slip);
  EXPECT_EQ(slips.shear, -20);
  EXPECT_EQ(slips.shear_per_normal, 0);
  EXPECT_EQ(admissible(strength, 20, 1, 15).state, ContactState::stick);
  const JointForce opens = admissible(strength, 20, -1, 15);
  EXPECT_EQ(opens.state, ContactState::open);
  EXPECT_EQ(opens.normal, 0);
  EXPECT_EQ(opens.shear, 15);
}

TEST(Neighbours, AreThoseThatAllPairsFind) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 30);
  std::uniform_real_distribution<double> size(0.2, 3);
  std::vector<Box> boxes;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d corner(place(random), place(random));
    const double side = i % 50 == 0 ? 25 : size(random);
    boxes.emplace_back(corner, corner + Eigen::Vector2d(side, side / 2));
  }
  std::vector<bool> movable(300, true);
  movable[0] = movable[3] = false;
  std::vector<std::pair<int, int>> all;
  for (int a = 0; a < 300; ++a) {
    for (int b = a + 1; b < 300; ++b) {
      const auto i = static_cast<std::size_t>(a);
      const auto j = static_cast<std::size_t>(b);
      if ((movable[i] || movable[j]) && boxes[i].intersects(boxes[j])) all.emplace_back(a, b);
    }
  }
  EXPECT_EQ(neighbours(boxes, movable), all);
}

}  // namespace
}  // namespace blockweir::solid::joint_law_test
