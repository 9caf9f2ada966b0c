// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_geometry bridge_scene
// Sections cut into blocks: areas, neighbours, dangling cuts, and the degenerate meetings of lines.
#include "bridge/geometry/cut.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"

namespace blockweir::geometry::section_cut_test {
namespace {

const Section square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}};

double area(const Cut& cut) {
  return std::accumulate(cut.pieces.begin(), cut.pieces.end(), 0.0,
                         [](double sum, const Piece& p) { return sum + geometry::signed_area(p.vertices); });
}

std::vector<std::size_t> corners(const Cut& cut) {
  std::vector<std::size_t> counts;
  for (const Piece& piece : cut.pieces) counts.push_back(piece.vertices.size());
  return counts;
}

TEST(SectionCut, WithoutLinesItIsOneBlock) {
  const Cut whole = cut(square, {});
  EXPECT_THAT(corners(whole), testing::ElementsAre(4));
  EXPECT_EQ(area(whole), 16);
}

TEST(SectionCut, ALinePartsItAndTheTwoAreNeighboursAlongIt) {
  const Cut two = cut(square, {{{{-1, 1}, {5, 3}}, 7}});
  EXPECT_THAT(corners(two), testing::ElementsAre(4, 4));
  EXPECT_NEAR(area(two), 16, 1e-14);
  ASSERT_EQ(two.neighbours.size(), 1U);
  EXPECT_EQ(two.neighbours[0].id, 7);
  EXPECT_EQ(two.pieces[0].vertices.size() + two.pieces[1].vertices.size(), 8U);
}

TEST(SectionCut, ALineThatEndsInABlockPartsNothing) {
  const Cut whole = cut(square, {{{{-1, 2}, {3, 2}}, 0}, {{{1, 1}, {2, 1}}, 1}, {{{2, 2}, {2, 3}}, 2}});
  EXPECT_THAT(corners(whole), testing::ElementsAre(4));
  EXPECT_NEAR(whole.dangling_m, 3 + 1 + 1, 1e-14);
}

TEST(SectionCut, ThreeLinesThroughOnePointMakeSixBlocksAndNoSliver) {
  // (4/3, 4/3) has no exact double; three lines through it must still meet there.
  const Cut six = cut(square, {{{{0, 0}, {4, 4}}, 0}, {{{0, 2}, {4, 0}}, 1}, {{{2, 0}, {0, 4}}, 2}});
  EXPECT_EQ(six.pieces.size(), 6U);
  EXPECT_NEAR(area(six), 16, 1e-13);
  for (const Piece& piece : six.pieces) EXPECT_GT(geometry::signed_area(piece.vertices), 0.1);
}

TEST(SectionCut, AJointAlongAnEdgeOfTheSectionChangesNothing) {
  const Cut whole = cut(square, {{{{-2, 0}, {6, 0}}, 0}, {{{4, 1}, {4, 2}}, 1}});
  EXPECT_THAT(corners(whole), testing::ElementsAre(4));
  EXPECT_TRUE(whole.neighbours.empty());
}

TEST(SectionCut, ATJunctionLeavesTheStraightSideWithoutACorner) {
  const Cut three = cut(square, {{{{0, 2}, {4, 2}}, 0}, {{{2, 2}, {2, 4}}, 1}});
  EXPECT_THAT(corners(three), testing::ElementsAre(4, 4, 4));
  EXPECT_EQ(three.neighbours.size(), 3U);
}

TEST(SectionCut, AHoleThatCutsReachLeavesSoundBlocks) {
  Section holed = square;
  holed.holes.push_back({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  const Cut two = cut(holed, {{{{0, 1.5}, {1, 1.5}}, 0}, {{{2, 1.5}, {4, 1.5}}, 1}});
  EXPECT_EQ(two.pieces.size(), 2U);
  EXPECT_EQ(area(two), 15);
  EXPECT_TRUE(two.enclosed.empty());
}

TEST(SectionCut, WhatABlockEnclosesIsTold) {
  Section holed = square;
  holed.holes.push_back({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  EXPECT_EQ(cut(holed, {}).enclosed.size(), 1U);
  const Cut ring = cut(square, {{{{1, 1}, {2, 1}, {2, 2}, {1, 1}}, 0}});
  EXPECT_EQ(ring.enclosed.size(), 1U);
  EXPECT_EQ(ring.pieces.size(), 1U);
}

TEST(SectionCut, ALoopThatHangsOnAPointIsEnclosed) {
  const Cut hung = cut(square, {{{{4, 2}, {2, 1}, {2, 3}, {4, 2}}, 0}});
  ASSERT_EQ(hung.enclosed.size(), 1U);
  EXPECT_EQ(hung.enclosed[0], Point(4, 2));
  EXPECT_EQ(hung.pieces.size(), 1U);
}

TEST(SectionCut, LinesThatAlmostMeetLeaveNoSliver) {
  const Cut four = cut(square, {{{{0, 0}, {4, 4}}, 0}, {{{0, 4}, {4, 0}}, 1}, {{{0, 1e-12}, {4, 4 + 1e-12}}, 2}});
  EXPECT_EQ(four.pieces.size(), 4U);
  EXPECT_NEAR(area(four), 16, 1e-10);
  for (const Piece& piece : four.pieces) EXPECT_FALSE(geometry::outline_fault(piece.vertices).has_value());
}

TEST(SectionCut, ASlenderBlockOfOneToAThousandStays) {
  EXPECT_EQ(cut(square, {{{{0, 2}, {4, 2}}, 0}, {{{0, 2.004}, {4, 2.004}}, 1}}).pieces.size(), 3U);
}

TEST(SectionCut, RandomLinesFillTheSectionWithSoundBlocksThatMeetExactly) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1, 5);
  int whole = 0;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Line> lines;
    for (int i = 0; i < 25; ++i) {
      lines.push_back({{Point(place(random), place(random)), Point(place(random), place(random))}, i});
    }
    const Cut many = cut(square, lines);
    if (many.enclosed.empty()) {
      EXPECT_NEAR(area(many), 16, 1e-12);
      ++whole;
    }
    for (const Piece& piece : many.pieces) EXPECT_FALSE(geometry::outline_fault(piece.vertices).has_value());
  }
  EXPECT_GT(whole, 10);
}

}  // namespace
}  // namespace blockweir::geometry::section_cut_test
