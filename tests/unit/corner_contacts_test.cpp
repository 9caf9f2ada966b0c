// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_limit
// Where corners of blocks meet other blocks in points.
#include "solid/limit/corner_contacts.hpp"

#include <gtest/gtest.h>

namespace blockweir::solid::limit {
namespace {

std::vector<CornerContact> contacts(const std::vector<Point>& a, const std::vector<Point>& b) {
  scene::Block one;
  scene::Block other;
  one.vertices = a;
  other.vertices = b;
  return corner_contacts(one, other, scene::trace_joint(one, other, 1e-6), 1e-6);
}

const std::vector<Point> ground = {{-5, -2}, {9, -2}, {9, 0}, {-5, 0}};

TEST(CornerContacts, ACornerOnAnEdgeIsHeldSquareToIt) {
  const std::vector<Point> tip = {{1, 0}, {2, 1}, {1, 2}, {0, 1}};
  for (const bool swapped : {false, true}) {
    const auto found = swapped ? contacts(tip, ground) : contacts(ground, tip);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].at_m, Point(1, 0));
    EXPECT_NEAR(found[0].normal.y(), swapped ? -1 : 1, 1e-12);
    EXPECT_FALSE(found[0].in_kink);
  }
}

TEST(CornerContacts, FacesHoldTheirEndsThemselves) {
  EXPECT_TRUE(contacts(ground, {{0, 0}, {2, 0}, {2, 3}, {0, 3}}).empty());
  EXPECT_TRUE(contacts(ground, {{0, 0}, {1, 0}, {2, 0}, {2, 3}, {0, 3}}).empty());  // a straight corner
  EXPECT_TRUE(contacts({{-5, -2}, {9, -2}, {9, 0}, {2, 0}, {1, 0}, {-5, 0}}, {{0, 0}, {2, 0}, {2, 3}, {0, 3}}).empty());
  EXPECT_TRUE(contacts({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{1, 1}, {3, 1}, {3, 2}, {1, 2}}).empty());  // bricks
}

TEST(CornerContacts, AReflexCornerHoldsByTheEdgeThatNoFaceRunsAlong) {
  const auto found =
      contacts({{-10, -4}, {14, -4}, {14, -0.5}, {3, -0.5}, {0, 0}, {-10, 0}}, {{0, 0}, {3, -0.5}, {2, 5}, {0, 5}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].at_m, Point(3, -0.5));
  EXPECT_NEAR((found[0].normal - Point(0, 1)).norm(), 0, 1e-12);
  EXPECT_TRUE(found[0].in_kink);
  const std::vector<Point> notch = {{-5, -2}, {9, -2}, {9, 0}, {1, -1}, {0, 0}, {-5, 0}};
  EXPECT_EQ(contacts(notch, {{1, -1}, {2, 1}, {0, 1}}).size(), 2U);  // a tip in a notch that is wider
}

TEST(CornerContacts, ConvexCornersThatMeetHoldNothing) {
  EXPECT_TRUE(contacts({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}).empty());
}

}  // namespace
}  // namespace blockweir::solid::limit
