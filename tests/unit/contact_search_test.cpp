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

std::vector<ContactPoint> contacts_within(double reach_m, const scene::Scene& scene = two_slabs()) {
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

/// Contacts of two outlines that do not touch.
std::vector<ContactPoint> contacts_between(const std::vector<Point>& one, const std::vector<Point>& other) {
  scene::Scene scene = two_slabs();
  scene.blocks[0].vertices = one;
  scene.blocks[1].vertices = other;
  return contacts_within(0.1, scene);
}

/// It would be through before it has "entered" by the end of a step.
TEST(ContactSearch, SeesACornerThatComesToAnEdgeNearItsEnd) {
  const auto contacts = contacts_between({{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}, {{-1, 0.2}, {0.007, 0.015}, {-0.5, 1}});
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].vertex_block, 0);
  EXPECT_NEAR(contacts[0].gap, 0.016, 0.001);
}

TEST(ContactSearch, SeesAcuteCornersOfWhichNeitherFacesAnEdge) {
  const auto contacts = contacts_between({{0.5, 0.02}, {1, 0}, {0.7, 0.6}}, {{1.006, 0}, {1.7, 0.1}, {1.02, 0.5}});
  EXPECT_EQ(contacts.size(), 1U);
}

TEST(ContactSearch, LetsCornersPassThatSlideOverEachOther) {
  EXPECT_TRUE(
      contacts_between({{-1, 0}, {-1e-3, 0}, {-1e-3, 0.5}, {-1, 0.5}}, {{0, -0.5}, {1, -0.5}, {1, 0}, {0, 0}}).empty());
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
