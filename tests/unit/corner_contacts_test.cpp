// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_limit
// Where corners of blocks meet other blocks in points.
#include "solid/limit/corner_contacts.hpp"

#include <gtest/gtest.h>

namespace blockweir::solid::limit::corner_contacts_test {
namespace {

using Outline = std::vector<Point>;

/// Of a block with each block of a body.
std::vector<CornerContact> with_body(const Outline& outline, const std::vector<Outline>& outlines) {
  scene::Block block;
  block.vertices = outline;
  std::vector<scene::Block> blocks(outlines.size());
  std::vector<Neighbour> body;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    blocks[i].vertices = outlines[i];
    body.push_back({static_cast<int>(i), &blocks[i], scene::trace_joint(block, blocks[i], 1e-6)});
  }
  std::vector<CornerContact> all;
  for (const Neighbour& of : body) {
    for (const CornerContact& found : corner_contacts(block, body, of, 1e-6)) all.push_back(found);
  }
  return all;
}
std::vector<CornerContact> contacts(const Outline& a, const Outline& b) {
  return with_body(a, {b});
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

/// A toe on a slope of one block and on the level top, or the side, of a second one.
TEST(CornerContacts, BlocksOfTheGroundFormAReflexCornerAsOneDoes) {
  const Outline slope = {{-10, -4}, {3, -4}, {3, -0.5}, {0, 0}, {-10, 0}};
  const Outline wall = {{0, 0}, {3, -0.5}, {2, 5}, {0, 5}};
  const auto level = with_body(wall, {slope, {{3, -4}, {14, -4}, {14, -0.5}, {3, -0.5}}});
  ASSERT_EQ(level.size(), 1U);
  EXPECT_NEAR((level[0].normal - Point(0, -1)).norm(), 0, 1e-12);
  const auto side = with_body(wall, {slope, {{3, -4}, {14, -4}, {14, 9}, {3, 9}}});
  ASSERT_EQ(side.size(), 1U);
  EXPECT_NEAR((side[0].normal - Point(1, 0)).norm(), 0, 1e-12);
  EXPECT_TRUE(with_body(wall, {slope, {{3, -4}, {14, -9}, {14, -8}, {3, -0.5}}}).empty());  // falls away: convex
}

TEST(CornerContacts, ATipStandsOnTheSeamOfLevelGround) {
  const auto found = with_body({{1, 0}, {2, 1}, {1, 2}, {0, 1}},
                               {{{-5, -2}, {1, -2}, {1, 0}, {-5, 0}}, {{1, -2}, {9, -2}, {9, 0}, {1, 0}}});
  ASSERT_FALSE(found.empty());
  for (const CornerContact& c : found) EXPECT_NEAR((c.normal - Point(0, -1)).norm(), 0, 1e-12);
}

/// A block that stands on the ground makes a reflex corner with the ground's top, which goes on below it.
TEST(CornerContacts, GroundThatStandsOnGroundHoldsByItsSide) {
  const auto found = with_body({{1, 0}, {3, 0}, {3, 2}, {2, 2}}, {ground, {{0, 0}, {1, 0}, {1, 3}, {0, 3}}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR((found[0].normal - Point(-1, 0)).norm(), 0, 1e-12);
}

TEST(CornerContacts, ConvexCornersThatMeetHoldNothing) {
  EXPECT_TRUE(contacts({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}).empty());
}

}  // namespace
}  // namespace blockweir::solid::limit::corner_contacts_test
