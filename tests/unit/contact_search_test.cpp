// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Which vertices may touch which edges.
#include "solid/contact/search.hpp"

#include <gtest/gtest.h>

namespace blockweir::solid {
namespace {

/// Two slabs on each other, 0.1 m and 0.2 m thick, the lower one wider.
scene::Scene two_slabs() {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.blocks.push_back({.name = "lower", .vertices = {{-1, -0.1}, {2, -0.1}, {2, 0}, {-1, 0}}});
  scene.blocks.push_back({.name = "upper", .vertices = {{0, 0}, {1, 0}, {1, 0.2}, {0, 0.2}}});
  return scene;
}

std::vector<ContactPoint> contacts_within(double reach_m) {
  const scene::Scene scene = two_slabs();
  const Parts parts = make_parts(scene);
  const JointLaws laws(scene);
  std::vector<Placement> placements;
  for (const Block& block : parts.blocks) placements.emplace_back(block.centroid, Vector6::Zero());
  std::vector<ContactPoint> contacts;
  ContactSearch(parts, laws, 1, reach_m, reach_m).update(placements, contacts);
  return contacts;
}

TEST(ContactSearch, FindsTheSameContactsWhereTheReachIsLongerThanBlocksAreThick) {
  for (const double reach : {0.05, 0.15, 0.35, 5.0}) {
    const auto contacts = contacts_within(reach);
    ASSERT_EQ(contacts.size(), 2U) << "reach " << reach;
    for (const ContactPoint& c : contacts) {
      EXPECT_EQ(c.vertex_block, 1) << "reach " << reach;
      EXPECT_EQ(c.edge, 2) << "reach " << reach;
      EXPECT_EQ(c.gap, 0) << "reach " << reach;
    }
  }
}

TEST(ContactSearch, LooksFartherOnceBlocksHaveMovedFarther) {
  const scene::Scene scene = two_slabs();
  const Parts parts = make_parts(scene);
  const JointLaws laws(scene);
  std::vector<Placement> placements;
  for (const Block& block : parts.blocks) placements.emplace_back(block.centroid, Vector6::Zero());
  Vector6 up = Vector6::Zero();
  up[1] = 0.02;
  placements[1] = Placement(parts.blocks[1].centroid, up);
  ContactSearch search(parts, laws, 1, 0.01, 0.1);
  std::vector<ContactPoint> contacts;
  search.update(placements, contacts);
  EXPECT_TRUE(contacts.empty());
  EXPECT_TRUE(search.covers(0.003));
  EXPECT_FALSE(search.covers(0.02));
  search.update(placements, contacts);
  EXPECT_EQ(contacts.size(), 2U);
  EXPECT_TRUE(search.covers(0.02));
}

}  // namespace
}  // namespace blockweir::solid
